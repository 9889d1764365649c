// Whole steps: what projection leaves, what controls change, what stops a run.
#include "core/simulation/simulation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/scene/parameters.h"
#include "core/session/lane.h"
#include "core/sources/smoke_stroke.h"

namespace whorl {
namespace {

Scene plume(std::initializer_list<const char*> settings = {}) {
    Scene scene = scene_of(experiment("plume"));
    for (const char* setting : settings) set_parameter(scene, setting);
    return scene;
}

/// After projection max |∇·u| h / |u|max is below this, in a box, periodic and around obstacles.
constexpr double divergence_limit = 1e-5;

TEST(Simulation, ProjectionLeavesNoDivergence) {
    Scene obstacle = plume();
    obstacle.obstacles = {{.x = 20, .y = 15, .radius = 4}};
    Scene periodic = scene_of(experiment("shear-layer"));
    for (const Scene& scene :
         {plume(), obstacle, periodic, plume({"order=smoke"}), plume({"resolution=63"})}) {
        Pool pool(1);
        Simulation simulation(scene, pool);
        for (int step = 0; step < 60; ++step) {
            simulation.step();
            ASSERT_LT(simulation.measures().relative_divergence, divergence_limit) << "step " << step;
        }
    }
}

TEST(Simulation, EveryControlActsOnTheNextStepWithoutAReset) {
    for (const Parameter& p : parameters()) {
        Pool pool(1);
        Simulation simulation(plume({"resolution=24"}), pool);
        for (int step = 0; step < 5; ++step) simulation.step();
        const double other = p.get(simulation.scene()) == p.slider_max ? p.slider_min : p.slider_max;
        try {
            Scene scene = simulation.scene();
            p.set(scene, p.kind == Parameter::Kind::Integer ? std::floor(other) : other);
            simulation.set(scene);
        } catch (const InputError&) {
            continue;  // not with these other choices; contracts cover which
        }
        simulation.step();
        EXPECT_EQ(simulation.state().step, 6) << p.key;
        EXPECT_GT(total(simulation.state().density(), simulation.state().boundary), 0) << p.key;
    }
}

TEST(Simulation, ResolutionResamplesTheRunningFields) {
    Pool pool(1);
    Simulation simulation(plume(), pool);
    for (int step = 0; step < 200; ++step) simulation.step();
    const double before = total(simulation.state().density(), simulation.state().boundary);
    const double percent = simulation.measures().density_percent();
    simulation.set(plume({"resolution=80"}));
    EXPECT_EQ(simulation.state().grid().nx, 80);
    EXPECT_NEAR(total(simulation.state().density(), simulation.state().boundary) / before, 1, 0.02);
    simulation.step();
    EXPECT_EQ(simulation.state().step, 201);
    EXPECT_NEAR(simulation.measures().density_percent(), percent, 1)
        << "resampling is not the scheme's doing";
}

TEST(Simulation, RefusesAChoiceAndStaysAsItWas) {
    Pool pool(1);
    Simulation simulation(plume({"interpolation=bicubic"}), pool);
    EXPECT_THROW(simulation.set(plume({"interpolation=bicubic", "advector=aslam"})), InputError);
    EXPECT_EQ(simulation.scene().scalars.advector, Id<Advector>("semi-lagrangian"));
    EXPECT_THROW(Simulation(plume({"interpolation=bicubic", "advector=aslam"}), pool), InputError);
}

TEST(Simulation, SameBitsForAnyThreadCount) {
    const auto run = [](int threads, const char* advector) {
        Pool pool(threads);
        Scene scene = plume({advector, "resolution=72", "confinement=2"});
        scene.obstacles = {{.x = 20, .y = 15, .radius = 4}};
        Simulation simulation(scene, pool);
        for (int step = 0; step < 30; ++step) simulation.step();
        std::vector<Real> bits;
        const State& s = simulation.state();
        for (const Field* f : {&s.density(), &s.temperature(), &s.velocity.u, &s.velocity.v, &s.pressure}) {
            for (int j = 0; j < f->height(); ++j) bits.insert(bits.end(), f->row(j), f->row(j) + f->width());
        }
        return bits;
    };
    for (const char* advector :
         {"advector=semi-lagrangian", "advector=maccormack", "advector=bfecc", "advector=aslam"}) {
        const auto one = run(1, advector);
        EXPECT_EQ(one, run(2, advector)) << advector;
        EXPECT_EQ(one, run(5, advector)) << advector;
    }
}

TEST(Simulation, DensityPercentCountsWhatEmittersPutIn) {
    Pool pool(1);
    Simulation simulation(plume(), pool);
    simulation.step();
    EXPECT_NEAR(simulation.measures().density_percent(), 100, 1);
    Simulation empty(scene_of(experiment("empty")), pool);
    empty.step();
    EXPECT_TRUE(std::isnan(empty.measures().density_percent())) << "nothing was put in";
}

TEST(Simulation, WalledInFluidStaysFinite) {
    Pool pool(1);
    Scene scene = plume({"resolution=32"});
    scene.obstacles = {{.x = 10, .y = 20, .radius = 0, .width = 20, .height = 1.5},
                       {.x = 20, .y = 10, .radius = 0, .width = 1.5, .height = 20},
                       {.x = 30, .y = 20, .radius = 0, .width = 20, .height = 1.5}};
    Lane lane(scene, pool);
    for (int step = 0; step < 60; ++step) ASSERT_TRUE(lane.step()) << *lane.failure();
    Scene solid = plume({"resolution=16"});
    solid.obstacles = {{.x = 20, .y = 20, .radius = 0, .width = 80, .height = 80}};
    Lane all_solid(solid, pool);
    for (int step = 0; step < 5; ++step) ASSERT_TRUE(all_solid.step()) << *all_solid.failure();
}

TEST(Lane, StopsAtANumberThatIsNotOneAndStartsAnew) {
    Pool pool(1);
    Lane lane(plume({"resolution=16"}), pool);
    ASSERT_TRUE(lane.step());
    lane.simulation().apply(
        SmokeStroke{.along = {20, 20, 20, 20}, .radius = 3, .amounts = {{field::density, std::nan("")}}});
    lane.simulation().apply(SmokeStroke{.along = {20, 20, 20, 20},
                                        .radius = 3,
                                        .amounts = {{field::density, 1}, {field::temperature, INFINITY}}});
    EXPECT_FALSE(lane.step());
    ASSERT_TRUE(lane.failure());
    EXPECT_NE(lane.failure()->find("step 2: "), std::string::npos) << *lane.failure();
    EXPECT_FALSE(lane.step()) << "it stays stopped";
    lane.restart();
    EXPECT_TRUE(lane.step());
}

TEST(Experiments, AreAllRunnableAndNamed) {
    Pool pool(1);
    for (const Experiment& e : experiments()) {
        SCOPED_TRACE(std::string(e.info.key));
        EXPECT_FALSE(e.info.help.empty());
        Scene scene = scene_of(e);
        if (scene.dimensions == 2) set_parameter(scene, "resolution=20");
        Lane lane(scene, pool);
        EXPECT_TRUE(lane.step());
        EXPECT_NO_THROW(experiment(e.info.key));
    }
    EXPECT_THROW(experiment("rotaton"), InputError);
}

/// Zalesak's disk comes back after one turn: the better the less the scheme dissipates, and the finer the
/// grid.
TEST(Experiments, ZalesakTurnsOnce) {
    const auto error = [](const char* advector, const char* resolution) {
        Pool pool(2);
        Scene scene = scene_of(experiment("zalesak"));
        set_parameter(scene, advector);
        set_parameter(scene, resolution);
        Lane lane(scene, pool);
        while (lane.simulation().state().step < 1200 && lane.step()) {
        }
        return lane.simulation().measures().errors.L1;
    };
    const double maccormack = error("advector=maccormack", "resolution=100");
    EXPECT_LT(maccormack, error("advector=semi-lagrangian", "resolution=100"));
    EXPECT_LT(maccormack, error("advector=maccormack", "resolution=50"));
}

}  // namespace
}  // namespace whorl
