// Strokes of the brush: smoke, pushes and obstacles.
#include <gtest/gtest.h>

#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"

namespace whorl {
namespace {

const Scene scene;

/// One quick stroke across the domain leaves smoke at every cell on its way.
TEST(Brush, LeavesAContinuousTrail) {
    State state = make_state(scene);
    apply(SmokeStroke{.along = {4, 20, 36, 22},
                      .radius = 1.5,
                      .amounts = {{field::density, 0.5}, {field::temperature, 30}}},
          state, scene);
    for (int i = 5; i < 35; ++i) {
        Real most = 0;
        for (int j = 15; j < 27; ++j) most = std::max(most, state.density()(i, j));
        EXPECT_GT(most, Real(0.2)) << "column " << i;
    }
    EXPECT_NEAR(state.injected[0], total(state.density(), state.boundary), 1e-5);
}

TEST(Brush, DragsTheFluidAlongAndPushesWithoutSmoke) {
    State state = make_state(scene);
    apply(SmokeStroke{.along = {10, 20, 20, 20}, .radius = 2, .push = 1, .velocity_x = 5, .smoke = false},
          state, scene);
    EXPECT_GT(state.velocity.u(15, 19), Real(3));
    EXPECT_EQ(total(state.density(), state.boundary), 0);
    EXPECT_EQ(state.injected[0], 0);
}

TEST(Brush, PaintsAndErasesObstacles) {
    State state = make_state(scene);
    apply(SmokeStroke{.along = {20, 20, 20, 20}, .radius = 4, .amounts = {{field::density, 1}}}, state,
          scene);
    const double before = state.injected[0];
    apply(ObstacleStroke{.along = {20, 20, 20, 20}, .radius = 2, .solid = true}, state, scene);
    EXPECT_TRUE(state.boundary.solid(20, 20));
    EXPECT_LT(state.injected[0], before) << "walled-in smoke is taken out of the account";
    EXPECT_NEAR(state.injected[0], total(state.density(), state.boundary), 1e-5);
    apply(ObstacleStroke{.along = {20, 20, 20, 20}, .radius = 3, .solid = false}, state, scene);
    EXPECT_FALSE(state.boundary.has_solids());
    EXPECT_EQ(state.density()(20, 20), 0);
    EXPECT_NEAR(state.injected[0], total(state.density(), state.boundary), 1e-5);
}

/// The smallest brush still meets a cell.
TEST(Brush, SmallestObstacleBrushMeetsACell) {
    State state = make_state(scene);
    apply(ObstacleStroke{.along = {20, 20, 20, 20}, .radius = 0.01, .solid = true}, state, scene);
    EXPECT_TRUE(state.boundary.has_solids());
}

}  // namespace
}  // namespace whorl
