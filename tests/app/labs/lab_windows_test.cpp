// The windows of the labs: they open, close, fit any screen, and are dragged in.
#include <gtest/gtest.h>
#include <imgui_internal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>

#include "app/labs/data_sets.h"
#include "app/labs/lab_widgets.h"
#include "app/window/lists.h"
#include "core/experiments/experiment.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

Scene small_rotation() {
    Scene scene = scene_of(experiment("rotation"));
    scene.resolution = 20;
    return scene;
}

std::vector<LaneSetup> three_lanes() {
    std::vector<LaneSetup> lanes(3);
    lanes[1].overrides = {{"interpolation", "fritsch-carlson"}};
    lanes[2].overrides = {{"interpolation", "catmull-rom"}};
    return lanes;
}

struct ControlRect {
    float x, y, width, height;
};

/// Where the trace says that the labs' controls lie, the last place of each.
std::map<std::string, ControlRect> places_in(const std::string& path) {
    std::map<std::string, ControlRect> places;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        char key[128];
        ControlRect at{};
        if (std::sscanf(line.c_str(),
                        "{\"event\":\"control\",\"key\":\"%127[^\"]\",\"x\":%f,\"y\":%f,\"w\":%f,\"h\":%f}",
                        key, &at.x, &at.y, &at.width, &at.height) == 5)
            places[key] = at;
    }
    return places;
}

struct TracePath {
    std::string path = testing::TempDir() + "labs-" + std::to_string(::getpid()) + ".trace";
    ~TracePath() { std::remove(path.c_str()); }
};

struct Screen {
    int width, height;
    float scale;
};
constexpr Screen screens[] = {{1024, 768, 1}, {900, 600, 1}, {1600, 1000, 1}, {2048, 1536, 2}};

TEST(Labs, CloseFromTheTopDown) {
    HeadlessUi ui(1600, 1000, 1);
    LanesWindow window(ui, {});
    LabWindows& labs = window.features.labs;
    EXPECT_FALSE(labs.close_top()) << "none has been open yet";
    labs.open("stencil") = true;
    window.frame();
    labs.open("interpolation") = true;
    window.frame();
    ImGui::SetWindowFocus("Stencil lab");
    window.frame();
    EXPECT_TRUE(labs.close_top());
    EXPECT_FALSE(labs.open("stencil"));
    EXPECT_TRUE(labs.open("interpolation"));
    window.frame();
    EXPECT_TRUE(labs.close_top());
    EXPECT_FALSE(labs.open("interpolation"));
    EXPECT_FALSE(labs.close_top());
}

TEST(LabWindows, NothingIsCutOffOnAnyScreen) {
    for (const Screen& screen : screens) {
        for (const LabEntry* entry : labs().all()) {
            const LabEntry& lab = *entry;
            SCOPED_TRACE(testing::Message() << lab.key << " on a screen " << screen.width << " wide");
            HeadlessUi ui(screen.width, screen.height, screen.scale);
            const TracePath trace;
            LanesWindow window(ui, {.setup = {.scene = small_rotation(), .lanes = three_lanes()}},
                               trace.path);
            window.features.labs.open(lab.key) = true;
            window.slice.compares_interpolations = true;
            window.inspector.pick({12, 9});
            window.player.step_once();
            ASSERT_TRUE(window.eventually([&] { return window.client.session().step == 1; }));
            for (int frame = 0; frame < 3; ++frame) window.frame();
            const ImGuiWindow* drawn = ImGui::FindWindowByName(lab.label);
            ASSERT_NE(drawn, nullptr);
            EXPECT_EQ(drawn->ScrollMax.y, 0) << "does not fit";
            EXPECT_EQ(drawn->ScrollMax.x, 0) << "does not fit";
            EXPECT_GE(drawn->Pos.x, 0);
            EXPECT_GE(drawn->Pos.y, 0);
            EXPECT_LE(drawn->Pos.x + drawn->Size.x, static_cast<float>(screen.width));
            EXPECT_LE(drawn->Pos.y + drawn->Size.y, static_cast<float>(screen.height));
            const std::string prefix(lab.key);
            std::size_t controls = 0;
            for (const auto& [key, at] : places_in(trace.path)) {
                if (key.rfind(prefix, 0) != 0 || key == prefix)
                    continue;  // a parameter's key is the bare word
                ++controls;
                EXPECT_GE(at.x - at.width / 2, drawn->Pos.x) << key;
                EXPECT_GE(at.y - at.height / 2, drawn->Pos.y) << key;
                EXPECT_LE(at.x + at.width / 2, drawn->Pos.x + drawn->Size.x) << key;
                EXPECT_LE(at.y + at.height / 2, drawn->Pos.y + drawn->Size.y) << key;
                EXPECT_GE(at.height, 10) << key;
            }
            EXPECT_GE(controls, 8u);
        }
    }
}

TEST(LabWindows, OpenByTheirChipsAndKeepStrokesOffTheField) {
    HeadlessUi ui(1280, 2400, 1);  // high enough for the whole column
    const TracePath trace;
    LanesWindow window(ui, {.setup = {.scene = small_rotation()}}, trace.path);
    window.frame();
    for (const LabEntry* entry : labs().all()) {
        const LabEntry& lab = *entry;
        const ControlRect chip = places_in(trace.path).at("lab=" + std::string(lab.key));
        window.click({chip.x, chip.y});
        window.frame();
        EXPECT_TRUE(window.features.labs.open(lab.key)) << lab.key;
        const ImGuiWindow* drawn = ImGui::FindWindowByName(lab.label);
        ASSERT_NE(drawn, nullptr);
        ImGui::GetIO().MousePos = {drawn->Pos.x + drawn->Size.x / 2, drawn->Pos.y + drawn->Size.y / 2};
        window.frame();
        window.frame();
        window.frame();
        EXPECT_TRUE(window.place.covered);
        window.features.labs.open(lab.key) = false;
        window.frame();
        window.frame();
        EXPECT_FALSE(window.place.covered);
        ImGui::GetIO().MousePos = {-FLT_MAX, -FLT_MAX};
    }
}

TEST(LabWindows, APointIsDraggedAndAnIntervalChosen) {
    HeadlessUi ui(1600, 1000, 1);
    const TracePath trace;
    LanesWindow window(ui, {.setup = {.scene = small_rotation()}}, trace.path);
    auto& lab = window.features.shared.of<InterpolationState>();
    window.features.labs.open("interpolation") = true;
    for (int frame = 0; frame < 3; ++frame) window.frame();
    const auto places = places_in(trace.path);
    const ControlRect point = places.at("interpolation-point=3");
    const float before = lab.values[3];
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {point.x, point.y};
    window.frame();
    io.MouseDown[0] = true;
    window.frame();
    io.MousePos.y -= 60;
    window.frame();
    io.MouseDown[0] = false;
    window.frame();
    EXPECT_GT(lab.values[3], before + 1);
    EXPECT_FALSE(lab.dragged);
    // Between points 1 and 2, off the curve.
    const ControlRect one = places_in(trace.path).at("interpolation-point=1");
    const ControlRect two = places_in(trace.path).at("interpolation-point=2");
    window.click({0.5f * (one.x + two.x), one.y - 80});
    EXPECT_EQ(lab.interval, 1);
    const ControlRect row = places_in(trace.path).at("interpolation-scheme=linear");
    window.click({row.x, row.y});
    EXPECT_FALSE(lab.shown[Id<Interpolation>("linear").index()]);
    const ControlRect set = places_in(trace.path).at("interpolation-data=spike");
    window.click({set.x, set.y});
    EXPECT_EQ(lab.values[5], 1);
}

TEST(LabWindows, CurvesThatLieOnEachOtherAreAllSeen) {
    HeadlessUi ui(1600, 1000, 1);
    const TracePath trace;
    LanesWindow window(ui, {.setup = {.scene = small_rotation()}}, trace.path);
    auto& lab = window.features.shared.of<InterpolationState>();
    window.features.labs.open("interpolation") = true;
    lab.shown.assign(lab.shown.size(), false);
    // Of the points that Figure 3.5 shows, in one dimension, these are one cubic.
    const std::size_t one[] = {Id<Interpolation>("catmull-rom").index(),
                               Id<Interpolation>("monotone-catmull-rom").index(),
                               Id<Interpolation>("bicubic").index()};
    for (const std::size_t k : one) lab.shown[k] = true;
    for (int frame = 0; frame < 3; ++frame) window.frame();
    const ControlRect card = places_in(trace.path).at("interpolation-inset");
    // The colour that was drawn last over each dozen of pixels.
    std::map<int, ImU32> on_top;
    const auto look = [&](const ImDrawVert& v) {
        if (std::abs(v.pos.x - card.x) > card.width / 2 || std::abs(v.pos.y - card.y) > card.height / 2)
            return;
        for (const std::size_t k : one) {
            if (v.col == interpolation_colour(ui.theme, k)) on_top[static_cast<int>(v.pos.x / 12)] = v.col;
        }
    };
    for (const ImGuiWindow* drawn : ImGui::GetCurrentContext()->Windows) {
        if (drawn->WasActive)
            std::for_each(drawn->DrawList->VtxBuffer.begin(), drawn->DrawList->VtxBuffer.end(), look);
    }
    ASSERT_GE(on_top.size(), 20u);
    for (const std::size_t k : one) {
        const auto seen = std::count_if(on_top.begin(), on_top.end(), [&](const auto& place) {
            return place.second == interpolation_colour(ui.theme, k);
        });
        EXPECT_GE(seen * 8, static_cast<long>(on_top.size())) << Id<Interpolation>::at(k).key();
    }
}

TEST(LabWindows, EveryInterpolationHasAColourOfItsOwn) {
    HeadlessUi ui(100, 100, 1);
    for (std::size_t a = 0; a < Interpolation::list().all().size(); ++a) {
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_NE(interpolation_colour(ui.theme, a), interpolation_colour(ui.theme, b));
    }
}

}  // namespace
}  // namespace whorl::app
