// Colour maps against their published tables.
#include "app/render/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace whorl::app {
namespace {

/// Linear interpolation of every eighth entry, in 1/255.
constexpr float tolerance = 3.5f;

void expect_colour(std::string_view key, float t, int r, int g, int b) {
    const ColourMap* map = find_colour_map(key);
    ASSERT_NE(map, nullptr) << key;
    const glm::vec3 colour = map->at(t) * 255.0f;
    EXPECT_NEAR(colour.r, static_cast<float>(r), tolerance) << key << " at " << t;
    EXPECT_NEAR(colour.g, static_cast<float>(g), tolerance) << key << " at " << t;
    EXPECT_NEAR(colour.b, static_cast<float>(b), tolerance) << key << " at " << t;
}

TEST(ColourMap, MatchesThePublishedTables) {
    expect_colour("viridis", 0.0f, 0x44, 0x01, 0x54);
    expect_colour("viridis", 64.0f / 255, 59, 82, 139);
    expect_colour("viridis", 128.0f / 255, 33, 145, 140);
    expect_colour("viridis", 1.0f, 0xfd, 0xe7, 0x25);
    expect_colour("magma", 0.0f, 0, 0, 4);
    expect_colour("magma", 128.0f / 255, 183, 55, 121);
    expect_colour("magma", 1.0f, 0xfc, 0xfd, 0xbf);
    expect_colour("inferno", 64.0f / 255, 87, 16, 110);
    expect_colour("inferno", 1.0f, 0xfc, 0xff, 0xa4);
    expect_colour("plasma", 0.0f, 0x0d, 0x08, 0x87);
    expect_colour("plasma", 127.0f / 255, 203, 70, 121);
}

TEST(ColourMap, DrawsSmokeBlackOnWhiteAsTheThesisDoes) {
    expect_colour("white-black", 0.0f, 255, 255, 255);
    expect_colour("white-black", 0.25f, 191, 191, 191);
    expect_colour("white-black", 1.0f, 0, 0, 0);
}

TEST(ColourMap, EndsHoldBeyondTheRange) {
    for (const ColourMap& map : colour_maps()) {
        EXPECT_EQ(map.at(-3.0f), map.at(0.0f)) << map.key;
        EXPECT_EQ(map.at(1e30f), map.at(1.0f)) << map.key;
        EXPECT_EQ(map.at(std::nanf("")), map.at(0.0f)) << map.key;
    }
}

TEST(ColourMap, DivergingMapsHaveANeutralMiddle) {
    for (const ColourMap& map : colour_maps()) {
        if (map.kind != ColourMap::Kind::Diverging) continue;
        EXPECT_EQ(map.points.size() % 2, 1u) << map.key;
        const glm::vec3 middle = map.at(0.5f);
        EXPECT_LT(std::abs(middle.r - middle.b), 0.05f) << map.key;
        EXPECT_GT(map.at(0.2f).b, map.at(0.2f).r) << map.key;
        EXPECT_GT(map.at(0.8f).r, map.at(0.8f).b) << map.key;
    }
}

TEST(ColourMap, KeysAreUnique) {
    std::set<std::string_view> keys;
    for (const ColourMap& map : colour_maps()) keys.insert(map.key);
    EXPECT_EQ(keys.size(), colour_maps().size());
    EXPECT_EQ(find_colour_map("no-such-map"), nullptr);
}

}  // namespace
}  // namespace whorl::app
