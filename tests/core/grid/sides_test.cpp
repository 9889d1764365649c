// Sides as rules: what wraps does so axis by axis, and sides of the tests' own go through a whole run.
#include "core/grid/sides.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/grid/boundary.h"
#include "core/scene/parameters.h"
#include "core/simulation/simulation.h"
#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"
#include "tests/support/channel.h"

namespace whorl {
namespace {

using test::channel_x;
using test::channel_y;

TEST(Sides, AChannelWrapsAlongOneAxis) {
    const Boundary channel(Grid{5, 3, 1}, channel_x);
    EXPECT_EQ(channel.wraps(), (Wraps{true, false}));
    EXPECT_EQ(channel.field(Site::FaceX).width(), 5);
    EXPECT_EQ(channel.field(Site::FaceY).height(), 4);
    EXPECT_FALSE(channel.solid(-1, 1));
    EXPECT_TRUE(channel.solid(1, -1));
    EXPECT_TRUE(channel.solid(1, 3));
    for (const Site site : {Site::Centre, Site::FaceX, Site::FaceY}) {
        Field q = channel.field(site);
        for (int j = 0; j < q.height(); ++j) {
            for (int i = 0; i < q.width(); ++i) q(i, j) = Real(100 * j + i);
        }
        channel.fill(q);
        for (int j = -2; j < q.height() + 2; ++j) {
            for (int i = -2; i < q.width() + 2; ++i)
                EXPECT_EQ(q(i, j), q((i + 5) % 5, std::clamp(j, 0, q.height() - 1)));
        }
    }
}

TEST(Sides, AreRefusedWhereNoBoundaryKeepsThem) {
    const Grid grid{5, 3, 1};
    EXPECT_THROW(Boundary(grid, Sides{{&periodic_side}, {}, {}, {}}), std::invalid_argument);
    EXPECT_THROW(Boundary(grid, Sides{{}, {}, {}, {&periodic_side}}), std::invalid_argument);
    SideKind sticky = wall_side;
    sticky.key = "no-slip";
    sticky.tangential = Condition::Zero;
    try {
        Boundary(grid, Sides{{}, {}, {&sticky}, {}});
        FAIL();
    } catch (const std::invalid_argument& e) {
        EXPECT_STREQ(e.what(), "no boundary keeps the conditions of a side that is no-slip");
    }
}

TEST(Sides, HaveAWordInFiles) {
    EXPECT_EQ(named(sides::box).info.key, "box");
    EXPECT_EQ(named(sides::periodic).info.key, "periodic");
    EXPECT_THROW(named(channel_x), InputError);
    const NamedSides channel{{"channel", "Channel", "", "Walls below and above."}, channel_x};
    NamedSides::list().add(channel);
    EXPECT_EQ(named(channel_x).info.key, "channel");
    NamedSides::list().remove(channel);

    Scene scene;
    EXPECT_EQ(scene.sides, sides::box);
    set_parameter(scene, "sides=periodic");
    EXPECT_EQ(scene.sides, sides::periodic);
    EXPECT_THROW(set_parameter(scene, "sides=round"), InputError);
}

TEST(Sides, DecideHowManyCellsASchemeNeeds) {
    Scene scene;
    set_parameter(scene, "interpolation=b-spline");
    set_parameter(scene, "resolution=40");
    set_parameter(scene, "height=3");
    EXPECT_NE(conflict(scene), "");
    scene.sides = channel_x;
    EXPECT_NE(conflict(scene), "");
    scene.sides = channel_y;
    EXPECT_EQ(conflict(scene), "");
}

/// A flow that leaves on the right and comes in on the left, with a wall in its way.
Simulation run(const Sides& sides, bool turned, const char* pressure, Pool& pool) {
    Scene scene;
    scene.sides = sides;
    for (const char* setting : {"resolution=24", "advector=maccormack", "tracer=rk3"})
        set_parameter(scene, setting);
    set_parameter(scene, "pressure", pressure);
    set_parameter(scene, "tolerance=1e-9");
    Simulation simulation(scene, pool);
    const auto turn = [&](Segment s) { return turned ? Segment{s.y0, s.x0, s.y1, s.x1} : s; };
    simulation.apply(ObstacleStroke{.along = turn({14, 21, 18, 23}), .radius = 2});
    SmokeStroke stroke{.along = turn({28, 18, 38, 20}),
                       .radius = 5,
                       .amounts = {{field::density, 1}, {field::temperature, 40}},
                       .push = 1,
                       .velocity_x = 30,
                       .velocity_y = 6};
    if (turned) std::swap(stroke.velocity_x, stroke.velocity_y);
    simulation.apply(stroke);
    for (int k = 0; k < 40; ++k) simulation.step();
    return simulation;
}

TEST(Sides, OfAChannelGoThroughAWholeRun) {
    // Of values near 1 in single precision, over 40 steps.
    constexpr double rounding = 2e-3;
    Pool pool(2);
    for (const char* pressure : {"ldlt", "conjugate-gradient", "multigrid"}) {
        SCOPED_TRACE(pressure);
        const Simulation along_x = run(channel_x, false, pressure, pool);
        const Simulation along_y = run(channel_y, true, pressure, pool);
        const State& a = along_x.state();
        const State& b = along_y.state();
        double through = 0;
        for (int j = 0; j < 24; ++j) {
            for (int i = 0; i < 24; ++i) {
                EXPECT_NEAR(a.density()(i, j), b.density()(j, i), rounding);
                EXPECT_NEAR(a.velocity.u(i, j), b.velocity.v(j, i), 10 * rounding);
                EXPECT_NEAR(a.velocity.v(i, j), b.velocity.u(j, i), 10 * rounding);
            }
            through += static_cast<double>(a.velocity.u(0, j) + a.density()(0, j));
            EXPECT_EQ(a.velocity.v(j, 0), 0);
            EXPECT_EQ(a.velocity.v(j, 24), 0);
        }
        EXPECT_GT(through, 1) << "smoke and flow have come in on the left";
    }
}

}  // namespace
}  // namespace whorl
