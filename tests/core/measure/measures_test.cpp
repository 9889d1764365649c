// What is summed over a flow, and what each phase of a step adds to it.
#include "core/measure/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/scene/parameters.h"
#include "core/simulation/simulation.h"
#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"

namespace whorl {
namespace {

/// Rounding of sums of some thousand doubles, over their sum.
constexpr double rounding = 1e-12;

Scene scene_with(const char* key, std::initializer_list<const char*> settings) {
    Scene scene = scene_of(experiment(key));
    for (const char* setting : settings) set_parameter(scene, setting);
    return scene;
}

FaceVelocity random_velocity(const Boundary& boundary) {
    std::mt19937 engine(static_cast<unsigned>(boundary.grid().nx));
    std::uniform_real_distribution<double> values(-1, 1);
    FaceVelocity velocity = boundary.velocity();
    for (Field* face : {&velocity.u, &velocity.v})
        write_samples(*face, boundary.grid(), [&](WorldPoint) { return values(engine); });
    boundary.enforce(velocity);
    return velocity;
}

double sum(const Measures& m, double PhaseShare::*of) {
    double all = 0;
    for (const auto& [key, share] : m.phases) all += share.*of;
    return all;
}

TEST(FlowReducer, AgreesWithPlainSums) {
    Pool pool(2);
    FlowReducer meter;
    const std::pair<int, int> shapes[] = {{1, 1}, {7, 5}, {8, 8}, {33, 17}, {40, 1}, {300, 210}};
    for (const Sides sides : {sides::box, sides::periodic}) {
        for (const auto& [nx, ny] : shapes) {
            for (const bool obstacles : {false, true}) {
                const Grid grid{nx, ny, 0.3};
                Boundary boundary(grid, sides);
                std::vector<std::uint8_t> mask(boundary.solids().size());
                for (std::size_t c = 0; c < mask.size(); ++c) mask[c] = obstacles && c % 13 == 4;
                boundary.set_solids(mask);
                const FaceVelocity velocity = random_velocity(boundary);
                const auto u = [&](int i, int j) {
                    return (static_cast<double>(velocity.u(i, j)) +
                            static_cast<double>(velocity.u(i + 1, j))) /
                           2;
                };
                const auto v = [&](int i, int j) {
                    return (static_cast<double>(velocity.v(i, j)) +
                            static_cast<double>(velocity.v(i, j + 1))) /
                           2;
                };
                double energy = 0, enstrophy = 0;
                for (int j = 0; j < ny; ++j) {
                    for (int i = 0; i < nx; ++i) {
                        const double across = velocity.u(i, j), up = velocity.v(i, j);
                        if (boundary.open_x(i, j)) energy += across * across / 2;
                        if (boundary.open_y(i, j)) energy += up * up / 2;
                        if (boundary.solid(i, j)) continue;
                        const double w =
                            (v(i + 1, j) - v(i - 1, j) - u(i, j + 1) + u(i, j - 1)) / (2 * grid.h);
                        enstrophy += w * w / 2;
                    }
                }
                const FlowSums sums = meter.measure(velocity, boundary, pool);
                EXPECT_NEAR(sums.kinetic_energy, energy * grid.cell(), rounding * energy)
                    << nx << " " << obstacles;
                // Vorticity is computed in Real: four roundings of terms that may cancel, on average much
                // less.
                EXPECT_NEAR(sums.enstrophy, enstrophy * grid.cell(),
                            (rounding + 8 * std::numeric_limits<Real>::epsilon()) * enstrophy)
                    << nx << " " << obstacles;
            }
        }
    }
}

TEST(FlowReducer, GivesTheSameBitsOnEveryInstructionSet) {
    const Boundary boundary({61, 9, 0.3}, sides::box);
    const FaceVelocity velocity = random_velocity(boundary);
    Pool pool(1);
    const FlowSums best = FlowReducer().measure(velocity, boundary, pool);
    for (const Isa isa : available_isas()) {
        const FlowSums sums = FlowReducer(isa).measure(velocity, boundary, pool);
        EXPECT_EQ(sums.kinetic_energy, best.kinetic_energy) << name(isa);
        EXPECT_EQ(sums.enstrophy, best.enstrophy) << name(isa);
    }
}

TEST(Errors, CountFluidCellsAlone) {
    Boundary boundary({6, 5, 0.5}, sides::box);
    std::vector<std::uint8_t> mask(30);
    mask[2 * 6 + 3] = 1;
    boundary.set_solids(mask);
    Field q = boundary.field(Site::Centre);
    const Field reference = boundary.field(Site::Centre, 1);
    q(3, 2) = 1000;
    q(1, 1) = 3;
    const Errors e = errors(q, reference, boundary);
    EXPECT_DOUBLE_EQ(e.L1, (28 * 1 + 2) * 0.25);
    EXPECT_DOUBLE_EQ(e.L2, std::sqrt((28 * 1 + 4) * 0.25));
    EXPECT_DOUBLE_EQ(e.Linf, 2);
}

TEST(PhaseChanges, AddUpToTheStepsChange) {
    for (const char* order : {"order=thesis", "order=smoke"}) {
        for (const char* advector : {"advector=semi-lagrangian", "advector=maccormack", "advector=aslam"}) {
            Pool pool(2);
            Scene scene = scene_with("plume", {order, advector, "resolution=48", "confinement=2"});
            scene.obstacles = {{.x = 20, .y = 15, .radius = 4}};
            Simulation simulation(scene, pool);
            for (int step = 0; step < 40; ++step) {
                const Measures before = simulation.measures();
                if (step == 20)
                    simulation.apply(
                        SmokeStroke{.along = {10, 10, 14, 12}, .radius = 3, .push = 1, .velocity_x = 20});
                if (step == 30)
                    simulation.apply(ObstacleStroke{.along = {10, 30, 30, 30}, .radius = 2, .solid = true});
                simulation.step();
                const Measures& after = simulation.measures();
                EXPECT_NEAR(sum(after, &PhaseShare::energy), after.kinetic_energy - before.kinetic_energy,
                            rounding * after.kinetic_energy)
                    << step;
                EXPECT_NEAR(sum(after, &PhaseShare::enstrophy), after.enstrophy - before.enstrophy,
                            rounding * after.enstrophy)
                    << step;
            }
            EXPECT_LT(simulation.measures().phase("advection").energy, 0) << "this plume loses energy";
        }
    }
}

TEST(PhaseChanges, ProjectionTakesWhatIsNotFreeOfDivergence) {
    Pool pool(1);
    Simulation simulation(scene_with("plume", {}), pool);
    for (int step = 0; step < 60; ++step) {
        simulation.step();
        // The projection is orthogonal: to its residual it takes energy.
        EXPECT_LE(simulation.measures().phase("projection").energy, 0) << step;
    }
    EXPECT_GT(simulation.measures().phase("forces").energy, 0) << "heat lifts the plume";
}

TEST(PhaseChanges, TheBrushIsAForce) {
    Pool pool(1);
    Simulation simulation(scene_with("empty", {"alpha=0", "beta=0"}), pool);
    simulation.step();
    EXPECT_EQ(simulation.measures().phase("forces").energy, 0);
    simulation.apply(SmokeStroke{.along = {20, 20, 22, 20}, .radius = 3, .push = 1, .velocity_x = 10});
    FlowReducer meter;
    const FlowSums stroke = meter.measure(simulation.state().velocity, simulation.state().boundary, pool);
    ASSERT_GT(stroke.kinetic_energy, 0);
    simulation.step();
    EXPECT_NEAR(simulation.measures().phase("forces").energy, stroke.kinetic_energy,
                rounding * stroke.kinetic_energy);
    EXPECT_NEAR(simulation.measures().phase("forces").enstrophy, stroke.enstrophy,
                rounding * stroke.enstrophy);
}

void set(Simulation& simulation, const char* setting) {
    Scene scene = simulation.scene();
    set_parameter(scene, setting);
    simulation.set(scene);
}

TEST(PhaseChanges, AChangeOfGridIsNobodys) {
    Pool pool(1);
    Simulation simulation(scene_with("empty", {"alpha=0", "beta=0"}), pool);
    simulation.apply(SmokeStroke{.along = {20, 20, 22, 20}, .radius = 3, .push = 1, .velocity_x = 10});
    FlowReducer meter;
    const FlowSums stroke = meter.measure(simulation.state().velocity, simulation.state().boundary, pool);
    set(simulation, "resolution=63");
    set(simulation, "sides=periodic");
    const FlowSums resampled = meter.measure(simulation.state().velocity, simulation.state().boundary, pool);
    ASSERT_NE(resampled.kinetic_energy, stroke.kinetic_energy);
    simulation.step();
    const Measures first = simulation.measures();
    EXPECT_NEAR(first.phase("forces").energy, stroke.kinetic_energy, rounding * stroke.kinetic_energy);
    EXPECT_NEAR(first.phase("forces").enstrophy, stroke.enstrophy, rounding * stroke.enstrophy);
    EXPECT_NEAR(first.kinetic_energy,
                resampled.kinetic_energy + first.phase("projection").energy + first.phase("advection").energy,
                rounding * stroke.kinetic_energy);
    simulation.step();
    EXPECT_EQ(simulation.measures().phase("forces").energy, 0) << "and is not left out twice";
}

TEST(PhaseChanges, StartAtNothing) {
    Pool pool(1);
    Simulation simulation(scene_with("taylor-green", {}), pool);
    for (int run = 0; run < 2; ++run) {
        EXPECT_EQ(sum(simulation.measures(), &PhaseShare::energy), 0);
        EXPECT_TRUE(std::isnan(simulation.measures().effective_viscosity));
        const double start = simulation.measures().kinetic_energy;
        ASSERT_GT(start, 0);
        simulation.step();
        EXPECT_NEAR(sum(simulation.measures(), &PhaseShare::energy),
                    simulation.measures().kinetic_energy - start, rounding * start);
        set(simulation, "resolution=50");
        simulation.restart();
    }
}

TEST(PhaseChanges, AreUnknownWhereTheFlowIsGiven) {
    Pool pool(1);
    Simulation simulation(scene_with("rotation", {}), pool);
    for (int step = 0; step < 2; ++step) {
        EXPECT_TRUE(std::isnan(simulation.measures().phase("advection").energy));
        EXPECT_TRUE(std::isnan(simulation.measures().phase("forces").enstrophy));
        EXPECT_TRUE(std::isnan(simulation.measures().effective_viscosity));
        EXPECT_GT(simulation.measures().kinetic_energy, 0);
        simulation.step();
    }
}

TEST(PhaseChanges, AreTheSameBitsForAnyThreadCount) {
    const auto run = [](int threads) {
        Pool pool(threads);
        Scene scene = scene_with("plume", {"resolution=200", "confinement=1"});
        scene.obstacles = {{.x = 20, .y = 15, .radius = 4}};
        Simulation simulation(scene, pool);
        for (int step = 0; step < 12; ++step) simulation.step();
        const Measures& m = simulation.measures();
        return std::vector{m.kinetic_energy,
                           m.enstrophy,
                           m.phase("forces").energy,
                           m.phase("projection").energy,
                           m.phase("advection").energy,
                           m.phase("forces").enstrophy,
                           m.phase("projection").enstrophy,
                           m.phase("advection").enstrophy,
                           m.effective_viscosity,
                           m.cfl};
    };
    const auto one = run(1);
    EXPECT_EQ(one, run(2));
    EXPECT_EQ(one, run(5));
}

}  // namespace
}  // namespace whorl
