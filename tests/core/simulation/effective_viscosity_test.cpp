// The effective viscosity of a scheme, against the decay of Taylor-Green vortices and what theory says of it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/scene/parameters.h"
#include "core/simulation/simulation.h"

namespace whorl {
namespace {

constexpr double speed = 4;  // of the experiment, length/time

Scene vortices(int resolution, std::initializer_list<const char*> settings) {
    Scene scene = scene_of(experiment("taylor-green"));
    scene.resolution = resolution;
    for (const char* setting : settings) set_parameter(scene, setting);
    return scene;
}

/// Wave number of the vortices along either axis, κ: |k|² = 2κ².
double wave_number(const Scene& scene) {
    return 2 * std::numbers::pi / scene.width;
}

/// What the central differences of the vorticity make of κ, over κ: a mean of two faces, and a difference
/// over two cells.
double seen(double kh) {
    return std::cos(kh / 2) * std::sin(kh) / kh;
}

struct Decay {
    double fitted;      ///< ν of E ~ exp(−2 ν |k|² t), |k| that of the vortices
    double advection;   ///< mean effective viscosity
    double projection;  ///< mean of what the projection takes, as a viscosity
    double per_step;    ///< share of the energy that a step takes
};

Decay decay(const Scene& scene) {
    constexpr int steps = 20;
    Pool pool(1);
    Simulation simulation(scene, pool);
    simulation.step();  // in the thesis' order the first projection finds nothing to take
    const double start = simulation.measures().kinetic_energy;
    Decay d{};
    for (int step = 0; step < steps; ++step) {
        const double enstrophy = simulation.measures().enstrophy;
        simulation.step();
        const Measures& m = simulation.measures();
        d.advection += m.effective_viscosity / steps;
        d.projection += effective_viscosity(m.phase("projection").energy, enstrophy, scene.dt) / steps;
    }
    const double k2 = 2 * wave_number(scene) * wave_number(scene);
    const double lost = -std::log(simulation.measures().kinetic_energy / start);
    d.fitted = lost / (2 * k2 * steps * scene.dt);
    d.per_step = lost / steps;
    return d;
}

TEST(EffectiveViscosity, IsThatOfTheDecayOfTaylorGreenVortices) {
    for (const int resolution : {20, 40, 80}) {
        for (const char* order : {"order=thesis", "order=smoke"}) {
            for (const auto& scheme : {std::pair{"advector=semi-lagrangian", "interpolation=linear"},
                                       std::pair{"advector=semi-lagrangian", "interpolation=fritsch-carlson"},
                                       std::pair{"advector=maccormack", "interpolation=linear"}}) {
                SCOPED_TRACE(testing::Message() << resolution << order << scheme.first << scheme.second);
                const Scene scene = vortices(resolution, {order, scheme.first, scheme.second});
                const double kh = wave_number(scene) * scene.grid().h;
                const Decay d = decay(scene);
                const double both = d.advection + d.projection;
                // The enstrophy is that of the grid's differences, of second order: 1 − 7/12 (κh)² + …
                EXPECT_NEAR(both / d.fitted, 1, kh * kh);
                // With what they see put right, one step's loss stands against a logarithm: half the loss.
                EXPECT_NEAR(both * seen(kh) * seen(kh) / d.fitted, 1, d.per_step);
            }
        }
    }
}

/// Advection by the exact flow keeps the energy, but leaves a gradient, −Δt u·∇u = Δt ∇p: the projection
/// takes its energy, ½ Δt² |∇p|². With u = U sin(κx) cos(κy) that is Δt U²/8 over a time step and 2Z.
TEST(EffectiveViscosity, OfTheProjectionIsWhatTheoryKnows) {
    const Scene scene = vortices(40, {"advector=maccormack"});
    const double kh = wave_number(scene) * scene.grid().h;
    const double expected = scene.dt * speed * speed / 8;
    EXPECT_NEAR(decay(scene).projection / expected, 1, kh * kh);
}

/// Linear interpolation at a fraction f of a cell adds ½ f(1 − f) h² q_xx a step: a viscosity of h² f(1 −
/// f)/(2Δt) along each axis. These vortices weigh both axes alike, and each place by its energy.
TEST(EffectiveViscosity, OfLinearInterpolationIsItsModifiedEquations) {
    for (const int resolution : {20, 40, 80, 160}) {
        const Scene scene = vortices(resolution, {});
        const double h = scene.grid().h;
        const double k = wave_number(scene);
        const auto along = [&](double velocity) {
            const double cells = std::abs(velocity) * scene.dt / h;
            const double f = cells - std::floor(cells);
            return h * h * f * (1 - f) / (2 * scene.dt);
        };
        double weighted = 0, weights = 0;
        for (int j = 0; j < resolution; ++j) {
            for (int i = 0; i < resolution; ++i) {
                const double x = k * i * h, y = k * (j + 0.5) * h;
                const double u = speed * std::sin(x) * std::cos(y), v = -speed * std::cos(x) * std::sin(y);
                weighted += u * u * (along(u) + along(v)) / 2;
                weights += u * u;
            }
        }
        Pool pool(1);
        Simulation simulation(scene, pool);
        simulation.step();
        // Both sides are of second order in h.
        EXPECT_NEAR(simulation.measures().effective_viscosity / (weighted / weights), 1, k * h * k * h)
            << resolution;
    }
}

TEST(EffectiveViscosity, OrdersTheSchemes) {
    const double linear = decay(vortices(40, {})).advection;
    const double cubic = decay(vortices(40, {"interpolation=fritsch-carlson"})).advection;
    const double corrected = decay(vortices(40, {"advector=maccormack"})).advection;
    EXPECT_GT(linear, 10 * cubic);
    EXPECT_GT(cubic, 10 * corrected);
}

TEST(EffectiveViscosity, OfSomeNumbers) {
    EXPECT_DOUBLE_EQ(effective_viscosity(-3, 5, 0.5), 0.6);
    EXPECT_LT(effective_viscosity(3, 5, 0.5), 0) << "what gains energy";
    EXPECT_TRUE(std::isnan(effective_viscosity(0, 0, 0.5))) << "still air";
}

}  // namespace
}  // namespace whorl
