// Buoyancy and confinement.
#include <gtest/gtest.h>

#include <cmath>

#include "core/forces/buoyancy.h"
#include "core/forces/confinement.h"
#include "core/scene/state.h"

namespace whorl {
namespace {

State still(int n = 20) {
    Scene scene;
    scene.resolution = n;
    return make_state(scene);
}

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

}  // namespace
}  // namespace whorl
