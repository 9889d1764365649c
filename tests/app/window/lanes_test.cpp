// Several lanes in the window: where their fields lie, what a hand does to them, and how they are compared.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "app/scenes/comparisons.h"
#include "app/tools/brush_tool.h"
#include "app/tools/view_tool.h"
#include "app/window/field_painter.h"
#include "core/experiments/experiment.h"
#include "core/sources/smoke_stroke.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

using Kind = InputEvent::Kind;

Scene box(double width, double height, int resolution) {
    Scene scene;
    scene.width = width;
    scene.height = height;
    scene.resolution = resolution;
    return scene;
}

std::vector<LaneSetup> lanes(int count) {
    std::vector<LaneSetup> all(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
        all[static_cast<std::size_t>(k)].overrides = {{"seed", std::to_string(k + 1)}};
    return all;
}

bool overlap(const PixelRect& a, const PixelRect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

struct Screen {
    int width, height;
    float scale;
};
constexpr Screen screens[] = {{1600, 1000, 1}, {1024, 768, 1}, {900, 600, 1}, {2048, 1536, 2}};

void expect_in_place(const LanesWindow& window, std::size_t tiles, double aspect) {
    ASSERT_EQ(window.place.tiles.size(), tiles);
    const Column& column = window.layout.field;
    for (const FieldTile& tile : window.place.tiles) {
        EXPECT_GE(tile.rect.x, column.x);
        EXPECT_LE(tile.rect.x + tile.rect.width, column.x + column.width);
        EXPECT_GE(tile.rect.y, window.layout.top);
        EXPECT_LE(tile.rect.y + tile.rect.height, window.layout.top + window.layout.height);
        // To a pixel of rounding.
        EXPECT_NEAR(tile.rect.height, tile.rect.width * aspect, 1.0 + aspect);
        EXPECT_GE(tile.rect.width, 40) << "too small to see";
        for (const FieldTile& other : window.place.tiles) {
            EXPECT_TRUE(&other == &tile || !overlap(tile.part, other.part));
        }
    }
}

TEST(LanesWindow, FieldsShareTheColumnInEveryModeAndSize) {
    for (const Screen& screen : screens) {
        HeadlessUi ui(screen.width, screen.height, screen.scale);
        FieldPainter painter;
        for (const auto& [width, height] : {std::pair{40.0, 40.0}, {40.0, 80.0}, {60.0, 20.0}}) {
            for (const int count : {1, 2, 3, 5, 6}) {
                LanesWindow window(ui, {.setup = {.scene = box(width, height, 30), .lanes = lanes(count)}});
                for (const Compare mode : {Compare::SideBySide, Compare::One, Compare::Wipe}) {
                    SCOPED_TRACE(testing::Message()
                                 << screen.width << " wide, " << count << " lanes, " << width << " by "
                                 << height << ", mode " << static_cast<int>(mode));
                    window.view.compare = mode;
                    window.view.difference = count > 1;
                    window.frame();
                    window.frame();
                    const std::size_t shown = mode == Compare::SideBySide ? static_cast<std::size_t>(count)
                                              : mode == Compare::One      ? 1u
                                                                          : std::min(2u, unsigned(count));
                    expect_in_place(window, shown, height / width);
                    painter.draw(window.client.session(), window.fields, window.view, window.place, ui.theme,
                                 screen.height);
                }
            }
        }
    }
}

TEST(LanesWindow, LanesOfOneAreaAreAsLargeAsTheyGet) {
    HeadlessUi ui(1600, 1000, 1);
    const auto columns = [&](double width, double height, int count) {
        LanesWindow window(ui, {.setup = {.scene = box(width, height, 30), .lanes = lanes(count)}});
        window.frame();
        int in_first_row = 0;
        for (const FieldTile& tile : window.place.tiles)
            in_first_row += tile.rect.y == window.place.tiles[0].rect.y;
        return in_first_row;
    };
    EXPECT_EQ(columns(40, 40, 4), 2);
    EXPECT_EQ(columns(40, 40, 5), 3);
    EXPECT_EQ(columns(40, 160, 5), 5);
    EXPECT_EQ(columns(160, 40, 3), 1);
}

TEST(LanesWindow, EveryControlHasAKeyInTheTrace) {
    const std::string path = testing::TempDir() + "lanes-" + std::to_string(::getpid()) + ".trace";
    HeadlessUi ui(1600, 1000, 1);
    {
        LanesWindow window(ui, {.setup = {.scene = box(40, 40, 20), .lanes = lanes(3)}}, path);
        window.view.window = {{0.25f, 0.25f}, {0.75f, 0.75f}};
        window.frame();
        window.rename_lane(1);
        window.frame();
    }
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    std::remove(path.c_str());
    for (const char* key : {"comparison",
                            "lane=1",
                            "lane=2",
                            "lane=3",
                            "lane-name",
                            "lane-duplicate",
                            "lane-remove",
                            "lane-up",
                            "lane-down",
                            "reference",
                            "refine=2",
                            "refine=4",
                            "refine=8",
                            "scope=all",
                            "scope=lane",
                            "compare=side-by-side",
                            "compare=one",
                            "compare=wipe",
                            "compare=difference",
                            "zoom-reset",
                            "lane-title=1",
                            "lane-title=3",
                            "field",
                            "field=3"}) {
        EXPECT_NE(text.str().find("\"key\":\"" + std::string(key) + "\""), std::string::npos) << key;
    }
}

TEST(LanesWindow, AClickOnATitleSelectsAndTabShowsTheLaneBefore) {
    HeadlessUi ui(1600, 1000, 1);
    LanesWindow window(ui, {.setup = {.scene = box(40, 40, 20), .lanes = lanes(4)}});
    window.frame();
    const auto title_of = [&](std::size_t lane) {
        const PixelRect& rect = window.place.tiles[lane].rect;
        return ImVec2{static_cast<float>(rect.x) + 20, static_cast<float>(rect.y) - 10};
    };
    window.click(title_of(1));
    EXPECT_EQ(window.client.selected(), 1u);
    EXPECT_EQ(window.client.other(), 0u) << "the one before";
    window.click(title_of(3));
    EXPECT_EQ(window.client.selected(), 3u);
    EXPECT_EQ(window.client.other(), 1u);
    window.view.compare = Compare::One;
    window.frame();
    const PixelRect alone = window.place.tiles[0].rect;
    EXPECT_EQ(window.place.tiles[0].lane, 3u);
    window.view.peek = true;
    window.frame();
    EXPECT_EQ(window.place.tiles[0].lane, 1u);
    EXPECT_EQ(window.place.tiles[0].rect.x, alone.x);
    EXPECT_EQ(window.place.tiles[0].rect.width, alone.width);
    EXPECT_EQ(window.client.selected(), 3u);
}

TEST(LanesWindow, OneStrokeOnAnyTileGoesIntoAllLanes) {
    HeadlessUi ui(1600, 1000, 1);
    // One of twice the resolution.
    std::vector<LaneSetup> all = lanes(3);
    all[2].refine = 2;
    LanesWindow window(ui, {.setup = {.scene = box(40, 40, 40), .lanes = all}});
    for (const ViewWindow& part : {ViewWindow{}, ViewWindow{{0.5f, 0.5f}, {1.0f, 1.0f}}}) {
        window.view.window = part;
        for (std::size_t lane = 0; lane < 3; ++lane) {
            window.client.restart();
            ASSERT_TRUE(window.eventually([&] { return window.client.snapshot().density()(30, 28) == 0; }));
            const PixelRect rect = window.place.tiles[lane].rect;
            // From (22, 28) to (30, 28), length units.
            const auto event = [&](Kind kind, double x) {
                const glm::dvec2 pixel = window.place.pixel(window.place.tiles[lane], {x, 28.5});
                EXPECT_GE(pixel.x, rect.x);
                return InputEvent{.kind = kind, .x = pixel.x, .y = pixel.y};
            };
            BrushTool brush(window.client);
            brush.take(event(Kind::Press, 22), window.place);
            brush.take(event(Kind::Move, 30), window.place);
            brush.take(event(Kind::Release, 30), window.place);
            brush.end_frame();
            EXPECT_TRUE(window.eventually([&] { return window.client.snapshot().density()(26, 28) > 0.1f; }));
            const auto& snapshots = window.client.session().lanes;
            for (int i = 22; i < 30; ++i) {
                EXPECT_GT(snapshots[0].density()(i, 28), 0.1f);
                EXPECT_EQ(snapshots[1].density()(i, 28), snapshots[0].density()(i, 28));
                EXPECT_GT(snapshots[2].density()(2 * i, 57), 0.1f);
            }
            EXPECT_EQ(snapshots[2].density()(16, 16), 0.0f);
        }
    }
}

TEST(LanesWindow, DifferencesAreFromTheReferenceAveragedToTheLane) {
    HeadlessUi ui(1024, 768, 1);
    std::vector<LaneSetup> all = lanes(3);
    all[1].refine = 2;
    LanesWindow window(ui,
                       {.setup = {.scene = scene_of(experiment("rotation")), .lanes = all, .reference = 1}});
    for (int k = 0; k < 3; ++k) window.player.step_once();
    ASSERT_TRUE(window.eventually([&] { return window.client.session().step == 3; }));
    window.view.difference = true;
    for (const View* each : views()) {
        const View& view = *each;
        if (!available(view, window.client.snapshot())) continue;
        window.view.shown = &view;
        window.frame();
        Field coarse_scratch, fine_scratch;
        const Snapshot& coarse = window.client.session().lanes[0];
        const Snapshot& fine = window.client.session().lanes[1];
        const Field& of_coarse = *view.field(coarse, coarse_scratch);
        const Field& of_fine = *view.field(fine, fine_scratch);
        const Field& shown = *window.fields.of(0);
        double largest = 0;
        for (int j = 0; j < coarse.grid().ny; ++j) {
            for (int i = 0; i < coarse.grid().nx; ++i) {
                const double mean =
                    0.25 * (static_cast<double>(of_fine(2 * i, 2 * j)) + of_fine(2 * i + 1, 2 * j) +
                            of_fine(2 * i, 2 * j + 1) + of_fine(2 * i + 1, 2 * j + 1));
                const double expected = static_cast<double>(of_coarse(i, j)) - mean;
                // Two roundings of values as large as these.
                const double rounding =
                    4e-7 * (std::abs(mean) + std::abs(static_cast<double>(of_coarse(i, j))));
                ASSERT_NEAR(shown(i, j), expected, rounding) << view.key;
                largest = std::max(largest, std::abs(static_cast<double>(shown(i, j))));
                ASSERT_EQ((*window.fields.of(1))(i, j), 0) << "the reference differs from itself in nothing";
            }
        }
        const Range range = window.view.range.ends();
        EXPECT_EQ(range.lo, -range.hi) << view.key;
        EXPECT_GE(static_cast<double>(range.hi), largest) << view.key;
        EXPECT_EQ(window.view.map().kind, ColourMap::Kind::Diverging);
    }
}

TEST(LanesWindow, OneRangeForAllLanes) {
    HeadlessUi ui(1024, 768, 1);
    std::vector<LaneSetup> all = lanes(3);
    all[1].overrides = {{"alpha", "5"}, {"beta", "1"}};
    LanesWindow window(ui, {.setup = {.scene = scene_of(experiment("plume")), .lanes = all}});
    for (int k = 0; k < 5; ++k) window.player.step_once();
    ASSERT_TRUE(window.eventually([&] { return window.client.session().step == 5; }));
    window.view.shown = &view("speed");
    window.frame();
    Field speed;
    float largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Snapshot& s = window.client.session().lanes[k];
        largest = std::max(largest, view("speed").automatic_range(s, *view("speed").field(s, speed)).hi);
    }
    EXPECT_EQ(window.view.range.ends().hi, largest);
}

TEST(LanesWindow, AStoppedLaneSaysSoAndTheOthersGoOn) {
    HeadlessUi ui(1024, 768, 1);
    std::vector<LaneSetup> all = lanes(2);
    // Air so hot that its lift overflows where heat lifts at all.
    all[0].overrides = {{"beta", "1000"}};
    LanesWindow window(ui, {.setup = {.scene = box(40, 40, 20), .lanes = all}});
    window.client.push(SmokeStroke{.along = {20, 20, 20, 20},
                                   .radius = 3,
                                   .amounts = {{field::density, 1}, {field::temperature, 3e37}}});
    window.player.play(true);
    ASSERT_TRUE(window.eventually([&] {
        window.player.begin_frame();
        return window.client.session().lanes[0].failure.has_value();
    }));
    const long then = window.client.session().step;
    EXPECT_TRUE(window.eventually([&] {
        window.player.begin_frame();
        return window.client.session().lanes[1].measures.step > then + 3;
    }));
    EXPECT_FALSE(window.client.session().lanes[1].failure);
}

TEST(LanesWindow, CurvesOfAllLanesInOneView) {
    HeadlessUi ui(1024, 768, 1);
    const Experiment* flat = nullptr;
    for (const Experiment& e : experiments()) {
        if (scene_of(e).dimensions == 1) flat = &e;
    }
    ASSERT_NE(flat, nullptr);
    std::vector<LaneSetup> all = lanes(3);
    all[2].refine = 2;
    LanesWindow window(ui, {.setup = {.scene = scene_of(*flat), .lanes = all}});
    for (const Compare mode : {Compare::SideBySide, Compare::One, Compare::Wipe}) {
        for (const bool difference : {false, true}) {
            window.view.compare = mode;
            window.view.difference = difference;
            window.frame();
            EXPECT_TRUE(window.place.tiles.empty()) << "nothing to paint on";
        }
    }
}

}  // namespace
}  // namespace whorl::app
