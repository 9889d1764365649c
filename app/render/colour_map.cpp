// See colour_map.h.
#include "app/render/colour_map.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "app/render/colour_tables.h"

namespace whorl::app {
namespace {

constexpr ColourMap maps[] = {
    {"magma", "Magma", ColourMap::Kind::Sequential, tables::magma},
    {"inferno", "Inferno", ColourMap::Kind::Sequential, tables::inferno},
    {"plasma", "Plasma", ColourMap::Kind::Sequential, tables::plasma},
    {"viridis", "Viridis", ColourMap::Kind::Sequential, tables::viridis},
    {"white-black", "White to black", ColourMap::Kind::Sequential, tables::white_black},
    {"blue-red", "Blue, white, red", ColourMap::Kind::Diverging, tables::blue_red},
    {"blue-dark-red", "Blue, dark, red", ColourMap::Kind::Diverging, tables::blue_dark_red},
};

glm::vec3 unpack(std::uint32_t rgb) {
    return glm::vec3((rgb >> 16) & 0xff, (rgb >> 8) & 0xff, rgb & 0xff) / 255.0f;
}

}  // namespace

glm::vec3 ColourMap::at(float t) const {
    const float last = static_cast<float>(points.size() - 1);
    const float place = t > 0.0f ? std::min(t, 1.0f) * last : 0.0f;
    const std::size_t low = std::min(static_cast<std::size_t>(place), points.size() - 2);
    return glm::mix(unpack(points[low]), unpack(points[low + 1]), place - static_cast<float>(low));
}

std::span<const ColourMap> colour_maps() {
    return maps;
}

const ColourMap* find_colour_map(std::string_view key) {
    const auto found =
        std::find_if(std::begin(maps), std::end(maps), [&](const ColourMap& m) { return m.key == key; });
    return found != std::end(maps) ? found : nullptr;
}

void ColourMapTexture::upload(const ColourMap& map) {
    if (texture_ && key_ == map.key) return;
    std::array<std::array<std::uint8_t, 4>, before + along> colours{};
    for (int k = 0; k < before + along; ++k) {
        const glm::vec3 shown = k < before
                                    ? glm::mix(below_colour, map.at(0.0f), static_cast<float>(k) / before)
                                    : map.at(static_cast<float>(k - before) / (along - 1));
        const glm::vec3 colour = shown * 255.0f + 0.5f;
        colours[static_cast<std::size_t>(k)] = {static_cast<std::uint8_t>(colour.r),
                                                static_cast<std::uint8_t>(colour.g),
                                                static_cast<std::uint8_t>(colour.b), 255};
    }
    if (!texture_) texture_ = GlTexture::create();
    glBindTexture(GL_TEXTURE_1D, texture_.name());
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, before + along, 0, GL_RGBA, GL_UNSIGNED_BYTE, colours.data());
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_1D, 0);
    key_ = map.key;
}

void ColourMapTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_1D, texture_.name());
}

}  // namespace whorl::app
