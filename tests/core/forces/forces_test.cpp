// Buoyancy, confinement, emitters and the brush.
#include <gtest/gtest.h>

#include <cmath>

#include "core/experiments/experiment.h"
#include "core/forces/brush.h"
#include "core/forces/buoyancy.h"
#include "core/forces/confinement.h"
#include "core/forces/emitters.h"

namespace whorl {
namespace {

State still(int n = 20) {
    Scene scene;
    scene.resolution = n;
    return make_state(scene);
}

/// Whose still air has 5 degrees.
const Scene cool;

TEST(Buoyancy, LiftsHeatAndSinksSmoke) {
    State state = still();
    Pool pool(1);
    state.temperature()(5, 5) = 25;  // 20 above ambient
    state.density()(10, 5) = 1;
    state.fill_ghosts();
    add_buoyancy(state, 2, 0.1, 5, 0.5, pool);
    // Half of each centre's force on either face.
    EXPECT_NEAR(state.velocity.v(5, 5), 0.5 * 0.5 * 0.1 * 20, 1e-6);
    EXPECT_NEAR(state.velocity.v(5, 6), 0.5 * 0.5 * 0.1 * 20, 1e-6);
    EXPECT_NEAR(state.velocity.v(10, 5), -0.5 * 0.5 * 2, 1e-6);
    EXPECT_EQ(state.velocity.v(15, 5), 0);
}

/// Around one vortex the force points along the turning flow: it feeds it.  [F fig 1]
TEST(Confinement, FeedsAVortex) {
    State state = still(21);
    Pool pool(1);
    const Grid& grid = state.grid();
    const double c = grid.width() / 2;
    for (int j = 0; j < state.velocity.u.height(); ++j) {
        for (int i = 0; i < state.velocity.u.width(); ++i) {
            const auto [x, y] = world(state.velocity.u, grid, i, j);
            state.velocity.u(i, j) =
                static_cast<Real>(-(y - c) * std::exp(-((x - c) * (x - c) + (y - c) * (y - c)) / 40));
        }
    }
    for (int j = 0; j < state.velocity.v.height(); ++j) {
        for (int i = 0; i < state.velocity.v.width(); ++i) {
            const auto [x, y] = world(state.velocity.v, grid, i, j);
            state.velocity.v(i, j) =
                static_cast<Real>((x - c) * std::exp(-((x - c) * (x - c) + (y - c) * (y - c)) / 40));
        }
    }
    state.fill_ghosts();
    const FaceVelocity before = state.velocity;
    Confinement confinement;
    confinement.add(state, 1, 0.1, pool);
    EXPECT_GT(state.velocity.v(13, 10), before.v(13, 10));
    EXPECT_LT(state.velocity.v(7, 10), before.v(7, 10));
    EXPECT_LT(state.velocity.u(10, 13), before.u(10, 13));
    EXPECT_GT(state.velocity.u(10, 7), before.u(10, 7));
}

TEST(Emitters, OpenForJustTheirSteps) {
    const Emitter emitter{.from = 0, .until = 10};
    int open = 0;
    double time = 0;
    for (int step = 0; step < 1200; ++step, time += 1.0 / 60)
        open += is_open(emitter, time, 1.0 / 60) ? 1 : 0;
    EXPECT_EQ(open, 600);
}

TEST(Emitters, HoldTheirValuesAndCountWhatTheyPutIn) {
    State state = still(40);
    const Emitter emitter{.x = 20,
                          .y = 1,
                          .width = 4,
                          .height = 2,
                          .amounts = {{field::density, 0.5}, {field::temperature, 50}}};
    apply_emitters(state, std::span(&emitter, 1), 0.1);
    EXPECT_EQ(state.density()(18, 0), Real(0.5));
    EXPECT_EQ(state.density()(21, 1), Real(0.5));
    EXPECT_EQ(state.density()(17, 0), 0);
    EXPECT_EQ(state.density()(18, 2), 0);
    EXPECT_EQ(state.temperature()(19, 1), 50);
    EXPECT_NEAR(state.injected[0], 0.5 * 4 * 2, 1e-9);
    apply_emitters(state, std::span(&emitter, 1), 0.1);
    EXPECT_NEAR(state.injected[0], 0.5 * 4 * 2, 1e-9) << "holding adds nothing";
}

/// One quick stroke across the domain leaves smoke at every cell on its way.
TEST(Brush, LeavesAContinuousTrail) {
    State state = still(40);
    apply(SmokeStroke{.along = {4, 20, 36, 22},
                      .radius = 1.5,
                      .amounts = {{field::density, 0.5}, {field::temperature, 30}}},
          state);
    for (int i = 5; i < 35; ++i) {
        Real most = 0;
        for (int j = 15; j < 27; ++j) most = std::max(most, state.density()(i, j));
        EXPECT_GT(most, Real(0.2)) << "column " << i;
    }
    EXPECT_NEAR(state.injected[0], total(state.density(), state.boundary), 1e-5);
}

TEST(Brush, DragsTheFluidAlongAndPushesWithoutSmoke) {
    State state = still(40);
    apply(SmokeStroke{.along = {10, 20, 20, 20}, .radius = 2, .push = 1, .velocity_x = 5, .smoke = false},
          state);
    EXPECT_GT(state.velocity.u(15, 19), Real(3));
    EXPECT_EQ(total(state.density(), state.boundary), 0);
    EXPECT_EQ(state.injected[0], 0);
}

TEST(Brush, PaintsAndErasesObstacles) {
    State state = still(40);
    apply(SmokeStroke{.along = {20, 20, 20, 20}, .radius = 4, .amounts = {{field::density, 1}}}, state);
    const double before = state.injected[0];
    apply(ObstacleStroke{.along = {20, 20, 20, 20}, .radius = 2, .solid = true}, state, cool);
    EXPECT_TRUE(state.boundary.solid(20, 20));
    EXPECT_LT(state.injected[0], before) << "walled-in smoke is taken out of the account";
    EXPECT_NEAR(state.injected[0], total(state.density(), state.boundary), 1e-5);
    apply(ObstacleStroke{.along = {20, 20, 20, 20}, .radius = 3, .solid = false}, state, cool);
    EXPECT_FALSE(state.boundary.has_solids());
    EXPECT_EQ(state.density()(20, 20), 0);
    EXPECT_NEAR(state.injected[0], total(state.density(), state.boundary), 1e-5);
}

/// The smallest brush still meets a cell.
TEST(Brush, SmallestObstacleBrushMeetsACell) {
    State state = still(40);
    apply(ObstacleStroke{.along = {20, 20, 20, 20}, .radius = 0.01, .solid = true}, state, cool);
    EXPECT_TRUE(state.boundary.has_solids());
}

}  // namespace
}  // namespace whorl
