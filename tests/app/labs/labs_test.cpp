// The labs: what they compute, that it is the solver's, and that their windows fit any screen.
#include <gtest/gtest.h>
#include <imgui_internal.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>

#include "app/labs/data_sets.h"
#include "app/labs/field_sampling.h"
#include "app/labs/interval_report.h"
#include "app/labs/lab_widgets.h"
#include "app/labs/monotone_region.h"
#include "app/labs/weight_profile.h"
#include "app/window/lists.h"
#include "core/experiments/experiment.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

constexpr double epsilon = std::numeric_limits<Real>::epsilon();

IntervalReport of_figure(std::string_view key, std::size_t data_set, bool clamped = false) {
    const DataSet& data = data_sets()[data_set];
    return report_on(row_of(data.values), Id<Interpolation>(key), clamped, data.interval);
}

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

TEST(InterpolationLab, SaysWhatFigure35Says) {
    // (a): monotone Catmull-Rom has a slight trough, Bridson's cubic undershoots, between 6 and 7.
    EXPECT_EQ(data_sets()[0].interval, 6);
    EXPECT_GT(of_figure("monotone-catmull-rom", 0).turned, 0.1);
    EXPECT_FALSE(of_figure("monotone-catmull-rom", 0).leaves_range());
    EXPECT_GT(of_figure("bridson", 0).below, 0.1);
    // (b): both overshoot between 5 and 6.
    EXPECT_EQ(data_sets()[1].interval, 5);
    EXPECT_GT(of_figure("monotone-catmull-rom", 1).above, 0.001);
    EXPECT_GT(of_figure("bridson", 1).above, 0.001);
    // In both, Fritsch and Carlson's neither overshoots nor turns.
    for (const std::size_t set : {0u, 1u}) {
        for (const IntervalReport& report :
             {of_figure("fritsch-carlson", set), of_figure("fritsch-carlson-square", set),
              of_figure("linear", set)})
            EXPECT_EQ(report.verdict(), "monotone");
    }
    // It interpolates, and the B-spline approximates.
    const Field row = row_of(data_sets()[0].values);
    const std::array<glm::dvec2, 1> node{glm::dvec2(7, 0)};
    std::array<float, 1> value;
    SchemeSet schemes;
    schemes.interpolation = Id<Interpolation>("fritsch-carlson");
    sample_field(row, schemes, Wraps{}, node, value);
    EXPECT_EQ(value[0], 15);
    schemes.interpolation = Id<Interpolation>("b-spline");
    sample_field(row, schemes, Wraps{}, node, value);
    EXPECT_GT(std::abs(value[0] - 15.0f), 1.0f);
}

TEST(InterpolationLab, ClampingKeepsTheRange) {
    for (std::size_t set = 0; set < data_sets().size(); ++set) {
        const DataSet& data = data_sets()[set];
        const Field row = row_of(data.values);
        for (std::size_t k = 0; k < Interpolation::list().all().size(); ++k) {
            for (int i = 0; i + 1 < row.width(); ++i)
                EXPECT_FALSE(report_on(row, Id<Interpolation>::at(k), true, i).leaves_range());
        }
    }
}

TEST(InterpolationLab, SlopesAreThoseOfTheThesis) {
    // Akima's data, interval 6: D = 4.5, δ = (15 − 10)/2 and (50 − 10.5)/2; the circle scales both to 3.
    const double alpha = 2.5 / 4.5, beta = 19.75 / 4.5, tau = 3 / std::hypot(alpha, beta);
    // The slopes are 24ths of sums of samples of size 50, times 192, over D.
    const double rounding = 192.0 / 24 * 4 * 50 / 4.5 * epsilon;
    EXPECT_NEAR(of_figure("monotone-catmull-rom", 0).alpha, alpha, rounding);
    EXPECT_NEAR(of_figure("monotone-catmull-rom", 0).beta, beta, rounding);
    EXPECT_NEAR(of_figure("fritsch-carlson", 0).alpha, tau * alpha, rounding);
    EXPECT_NEAR(of_figure("fritsch-carlson", 0).beta, tau * beta, rounding);
    EXPECT_NEAR(of_figure("fritsch-carlson-square", 0).beta, 3, rounding);
    EXPECT_NEAR(of_figure("linear", 0).alpha, 1, rounding);
}

TEST(InterpolationLab, RegionsBoundaryIsWhereItEnds) {
    for (int k = 1; k < 100; ++k) {
        const glm::dvec2 at = region_boundary(k / 100.0);
        const glm::dvec2 out = 1e-6 * (at - glm::dvec2(1, 1));
        EXPECT_TRUE(is_monotone(at.x - out.x, at.y - out.y)) << at.x << ' ' << at.y;
        EXPECT_FALSE(is_monotone(at.x + out.x, at.y + out.y)) << at.x << ' ' << at.y;
    }
    EXPECT_TRUE(is_monotone(0, 0));
    EXPECT_TRUE(is_monotone(3, 0));
    EXPECT_TRUE(is_monotone(0, 3));
    EXPECT_FALSE(is_monotone(3.1, 0));
    EXPECT_FALSE(is_monotone(-0.1, 1));
}

RC_GTEST_PROP(InterpolationLab, ACurveIsMonotoneExactlyWhereItsSlopesLieInTheRegion, ()) {
    std::vector<float> values;
    for (int k = 0; k < 8; ++k) values.push_back(static_cast<float>(*rc::gen::inRange(-20, 21)));
    const Field row = row_of(values);
    const int i = *rc::gen::inRange(0, 7);
    for (std::size_t k = 0; k < Interpolation::list().all().size(); ++k) {
        const auto id = Id<Interpolation>::at(k);
        if (id == Id<Interpolation>("b-spline")) continue;  // leaves its points' range by approximating
        const IntervalReport report = report_on(row, id, false, i);
        if (report.flat) continue;
        const bool monotone = is_monotone(report.alpha, report.beta);
        // Too near the boundary a reversal is smaller than what samples show.
        constexpr double near = 0.1;
        bool clear = true;
        for (const double a : {-near, near}) {
            for (const double b : {-near, near})
                clear &= is_monotone(report.alpha + a, report.beta + b) == monotone;
        }
        if (clear) RC_ASSERT((report.verdict() == "monotone") == monotone);
        if (id == Id<Interpolation>("fritsch-carlson") || id == Id<Interpolation>("fritsch-carlson-square"))
            RC_ASSERT(report.verdict() == "monotone");
    }
}

RC_GTEST_PROP(InterpolationLab, CurvesAreTheSchemesOwn, ()) {
    std::vector<float> values;
    for (int k = 0; k < 9; ++k) values.push_back(0.1f * static_cast<float>(*rc::gen::inRange(-99, 100)));
    const Field row = row_of(values);
    const int i = *rc::gen::inRange(2, 5);
    const int part = *rc::gen::inRange(0, 64);
    const std::array<glm::dvec2, 1> place{glm::dvec2(i + part / 64.0, 0)};
    const auto t = static_cast<Real>(part / 64.0);
    for (std::size_t k = 0; k < Interpolation::list().all().size(); ++k) {
        SchemeSet schemes;
        schemes.interpolation = Id<Interpolation>::at(k);
        std::array<float, 1> value;
        sample_field(row, schemes, Wraps{}, place, value);
        const whorl::Interval in{i, row.width() - 1, false};
        const Real expected =
            schemes.interpolation->at({row(i - 1, 0), row(i, 0), row(i + 1, 0), row(i + 2, 0)}, t, in);
        RC_ASSERT(value[0] == static_cast<float>(expected));
    }
}

double length(Vec2 offset) {
    return std::hypot(static_cast<double>(offset.x), static_cast<double>(offset.y));
}

std::size_t particles_in_table_41(Id<StencilShape> kind, std::size_t zeta, int dimensions) {
    const std::size_t side = kind == Id<StencilShape>("subsampling") ? zeta + 1 : 2 * zeta + 1;
    if (dimensions == 1) return side;
    // The Delannoy number of 2 and ζ.
    return kind == Id<StencilShape>("manhattan") ? 2 * zeta * zeta + 2 * zeta + 1 : side * side;
}

TEST(StencilLab, ParticlesAreThoseOfTable41AndLieOnTheProfile) {
    for (std::size_t kind = 0; kind < StencilShape::list().all().size(); ++kind) {
        for (std::size_t weights = 0; weights < WeightKernel::list().all().size(); ++weights) {
            for (const int dimensions : {1, 2}) {
                for (int zeta = 1; zeta <= SchemeSet::max_zeta; ++zeta) {
                    const auto id = Id<StencilShape>::at(kind);
                    const Stencil stencil(id, zeta, Id<WeightKernel>::at(weights), dimensions, 7);
                    const WeightProfile profile(stencil, dimensions, Id<WeightKernel>::at(weights));
                    EXPECT_EQ(stencil.particles().size(),
                              particles_in_table_41(id, static_cast<std::size_t>(zeta), dimensions));
                    double sum = 0;
                    for (const Particle& particle : stencil.particles()) {
                        const auto weight = static_cast<double>(particle.weight);
                        sum += weight;
                        // Offsets and weights are rounded to Real; SPH's third power triples what r has.
                        EXPECT_NEAR(profile(length(particle.offset)), weight, 8 * epsilon * weight);
                    }
                    EXPECT_NEAR(sum, 1, epsilon * static_cast<double>(stencil.particles().size()));
                }
            }
        }
    }
}

TEST(StencilLab, SphWeightsOfACellsCornersAreATenthOfTheNodesAtLeast) {
    const Stencil stencil(Id<StencilShape>("chessboard"), 2, Id<WeightKernel>("sph"), 2, 1);
    const WeightProfile profile(stencil, 2, Id<WeightKernel>("sph"));
    const double ratio = profile(Stencil::radius(2)) / profile(0);
    EXPECT_NEAR(ratio, std::pow(1 - 1 / (1.5 * 1.5), 3), 1e-12);  // [T 4.7], in doubles
    EXPECT_GE(ratio, 0.1);
}

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
