// Where limiters act: as views, and as a plot.
#include <gtest/gtest.h>

#include <cmath>

#include "app/charts/measure_tabs.h"
#include "core/experiments/experiment.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

Recording clamped_plume() {
    Scene scene = scene_of(experiment("plume"));
    scene.resolution = 24;
    std::vector<LaneSetup> lanes(2);
    lanes[1].overrides = {{"advector", "maccormack"}};
    lanes[0].overrides = {{"advector", "semi-lagrangian"}};
    return {.setup = {.scene = scene, .lanes = lanes}, .commands = {}, .step = 10};
}

double sum(const Field& field) {
    double sum = 0;
    for (int j = 0; j < field.height(); ++j) {
        for (int i = 0; i < field.width(); ++i) sum += static_cast<double>(field(i, j));
    }
    return sum;
}

TEST(LimitedViews, ShowWhatLimitersChangedAndCostNothingElse) {
    HeadlessUi ui(1280, 800, 1);
    LanesWindow window(ui, clamped_plume());
    ASSERT_TRUE(window.eventually([&] { return window.client.session().step == 10; }));
    const auto limits = [&](std::size_t k) { return window.client.session().lanes[k].limits.has_value(); };
    EXPECT_FALSE(limits(1));
    for (const char* key : {"limited-smoke", "limited-velocity"}) {
        window.view.shown = &view(key);
        EXPECT_TRUE(available(*window.view.shown, window.client.snapshot())) << "so that it can be chosen";
        ASSERT_TRUE(window.eventually([&] { return limits(0) && limits(1); }));
        window.frame();
        ASSERT_EQ(&window.fields.view(), &view(key));
        EXPECT_EQ(sum(*window.fields.of(0)), 0) << "linear interpolation has no limiter";
        const Snapshot& maccormack = window.client.session().lanes[1];
        // A face of the velocity belongs to two cells, a quarter of each, but on the sides.
        const double counted = std::string_view(key) == "limited-smoke"
                                   ? maccormack.measures.limited.density
                                   : maccormack.measures.limited.velocity / 2;
        EXPECT_GT(counted, 0);
        EXPECT_LE(sum(*window.fields.of(1)), counted);
        EXPECT_GT(sum(*window.fields.of(1)), counted / 3);
        window.view.shown = views().front();
        EXPECT_TRUE(window.eventually([&] { return !limits(1); }));
    }
}

TEST(LimitedViews, CountsArePlottedWhileTheyAreWatched) {
    HeadlessUi ui(1280, 800, 1);
    LanesWindow window(ui, clamped_plume());
    ASSERT_TRUE(window.eventually([&] { return window.client.session().step == 10; }));
    const auto titles = [&] {
        std::vector<std::string> found;
        for (const SheetPlot& plot : plots_of(window.history, window.client.session(), window.measure_view))
            found.push_back(plot.title);
        return found;
    };
    const auto shown = [&] { return std::ranges::count(titles(), "Limited nodes of smoke"); };
    EXPECT_EQ(shown(), 0);
    window.view.count_limited = true;
    window.frame();
    window.player.step_once();
    ASSERT_TRUE(window.eventually([&] { return window.client.session().step == 11; }));
    EXPECT_EQ(shown(), 1);
    const int id = window.client.session().ids[1];
    EXPECT_EQ(window.history.lane(id).of(measures().find("limited_density")).back(),
              static_cast<float>(window.client.session().lanes[1].measures.limited.density));
    EXPECT_TRUE(std::isnan(window.history.lane(id).of(measures().find("limited_density")).front()))
        << "not watched then";
}

TEST(LimitedViews, PicturesHaveThemWithoutBeingAskedBefore) {
    Pool pool(1);
    Session session(clamped_plume(), pool);
    for (int k = 0; k < 10; ++k) session.step();
    SessionSnapshot shown;
    take_shown(session, view("limited-smoke"), shown, pool, shown);
    ASSERT_TRUE(shown.lanes[1].limits);
    EXPECT_EQ(sum(shown.lanes[1].limits->density), shown.lanes[1].measures.limited.density);
    EXPECT_FALSE(session.watches_limiters());
    take_shown(session, view("density"), shown, pool, shown);
    EXPECT_FALSE(shown.lanes[1].limits);
    // A flow that is given is not limited.
    Scene rotation = scene_of(experiment("rotation"));
    Session given({.setup = {.scene = rotation}, .commands = {}, .step = 0}, pool);
    take_shown(given, view("limited-velocity"), shown, pool, shown);
    Field scratch;
    EXPECT_EQ(view("limited-velocity").field(shown.lanes[0], scratch), nullptr);
}

}  // namespace
}  // namespace whorl::app
