// Measures that add up rows of cells while they are asked for.
#include <gtest/gtest.h>

#include <cmath>

#include "core/session/session.h"

namespace whorl {
namespace {

/// Mean height of the smoke.
const Measure height{.key = "height",
                     .title = "Height",
                     .unit = "length",
                     .help = "∫ρy / ∫ρ",
                     .row =
                         [](const RowView& row, Sums& sums) {
                             for (const int i : row.fluid()) {
                                 sums[0] += static_cast<double>(row.density[i]);
                                 sums[1] += static_cast<double>(row.density[i]) * row.y;
                             }
                         },
                     .value = [](const Measures&, const Sums& sums) { return sums[1] / sums[0]; }};

Scene plume() {
    Scene scene = scene_of(experiment("plume"));
    scene.resolution = 24;
    scene.obstacles.push_back({.x = 20, .y = 10, .width = 12, .height = 3});
    return scene;
}

double height_of(const State& state) {
    double sum = 0, moment = 0;
    for (int j = 0; j < state.grid().ny; ++j) {
        for (int i = 0; i < state.grid().nx; ++i) {
            if (state.boundary.solid(i, j)) continue;
            sum += static_cast<double>(state.density()(i, j));
            moment += static_cast<double>(state.density()(i, j)) * (j + 0.5) * state.grid().h;
        }
    }
    return moment / sum;
}

TEST(Reduction, IsWorkedOutWhileItIsAskedFor) {
    Pool pool(2);
    Session session({.setup = {.scene = plume(), .lanes = std::vector<LaneSetup>(2)}}, pool);
    for (int step = 0; step < 5; ++step) session.step();
    EXPECT_TRUE(std::isnan(height.of(session.measures(1)))) << "nothing asks";
    const Measure* const asked[] = {&height};
    session.ask(asked);
    EXPECT_NEAR(height.of(session.measures(1)), height_of(session.lane(1).simulation().state()), 1e-9)
        << "at once";
    std::vector<double> values;
    for (int step = 5; step < 25; ++step) {
        session.step();
        values.push_back(height.of(session.measures(0)));
        ASSERT_NEAR(values.back(), height_of(session.lane(0).simulation().state()), 1e-9);
    }
    // A step that is taken again has its value again.
    session.rewind(20);
    ASSERT_EQ(session.step_number(), 20);
    EXPECT_EQ(height.of(session.measures(0)), values[14]);
    session.step();
    EXPECT_EQ(height.of(session.measures(0)), values[15]);
    session.ask({});
    EXPECT_TRUE(std::isnan(height.of(session.measures(0))));
}

TEST(Reduction, DoesNotDependOnThreadsAndChangesNothing) {
    const auto run = [](int threads, bool ask) {
        Scene scene = plume();
        scene.resolution = 160;  // enough for several bands
        Pool pool(threads);
        Session session({.setup = {.scene = scene}}, pool);
        const Measure* const asked[] = {&height};
        if (ask) session.ask(asked);
        for (int step = 0; step < 4; ++step) session.step();
        return std::pair(height.of(session.measures(0)), session.digest());
    };
    const auto one = run(1, true);
    EXPECT_EQ(one, run(3, true));
    EXPECT_EQ(one.second, run(1, false).second);
}

/// What a lane had in its last step goes with it, and to the lane that goes on from it.
TEST(Reduction, GoesWithItsLane) {
    Pool pool(1);
    Session session({.setup = {.scene = plume()}}, pool);
    const Measure* const asked[] = {&height};
    session.ask(asked);
    for (int step = 0; step < 3; ++step) session.step();
    const double before = height.of(session.measures(0));
    session.apply(Arrange{.lanes = std::vector<LaneSetup>(2), .from = {0, 0}, .reference = no_reference});
    EXPECT_EQ(height.of(session.measures(0)), before);
    EXPECT_EQ(height.of(session.measures(1)), before);
}

}  // namespace
}  // namespace whorl
