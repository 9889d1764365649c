// The spectrum holds all of a flow's energy, each mode in its own shell.
#include "core/measure/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/measure/flow_sums.h"
#include "core/scene/state.h"
#include "tests/support/channel.h"

namespace whorl {
namespace {

/// Rounding of sums of some thousand doubles, over their sum.
constexpr double rounding = 1e-12;
/// That, and of samples rounded to Real, twice for a square.
constexpr double sample_rounding = rounding + 4 * std::numeric_limits<Real>::epsilon();

FaceVelocity random_velocity(const Boundary& boundary, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> values(-1, 1);
    FaceVelocity velocity = boundary.velocity();
    for (Field* face : {&velocity.u, &velocity.v})
        write_samples(*face, boundary.grid(), [&](WorldPoint) { return values(engine); });
    boundary.enforce(velocity);
    return velocity;
}

/// ½⟨|u|²⟩, sample by sample.
double mean_energy(const FaceVelocity& velocity, const Boundary& boundary) {
    const Grid& grid = boundary.grid();
    const auto square = [](Real x) { return static_cast<double>(x) * static_cast<double>(x); };
    double sum = 0;
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            if (boundary.open_x(i, j)) sum += square(velocity.u(i, j));
            if (boundary.open_y(i, j)) sum += square(velocity.v(i, j));
        }
    }
    return sum / 2 / grid.nx / grid.ny;
}

double total_energy(const Spectrum& spectrum) {
    double sum = 0;
    for (const double e : spectrum.energy()) sum += e * spectrum.spacing();
    return sum;
}

TEST(Spectrum, HoldsAllEnergyOfAnyFlowOfAnyShape) {
    const std::pair<int, int> shapes[] = {{16, 16}, {15, 15}, {12, 20}, {21, 8}, {1, 9},
                                          {9, 1},   {8, 1},   {1, 1},   {2, 2},  {3, 7},
                                          {26, 13}, {74, 77}, {97, 2},  {4, 4},  {5, 64}};
    Spectrum spectrum;  // one for all, so that nothing of an earlier shape may stay
    for (const Sides& sides : test::all_sides) {
        for (const auto& [nx, ny] : shapes) {
            for (const bool obstacles : {false, true}) {
                Boundary boundary({nx, ny, 0.37}, sides);
                SCOPED_TRACE(testing::Message() << nx << " x " << ny << " " << test::name(sides)
                                                << (obstacles ? " obstacles" : ""));
                if (obstacles) {
                    std::vector<std::uint8_t> mask(boundary.solids().size());
                    for (std::size_t c = 0; c < mask.size(); ++c) mask[c] = c % 7 == 3 || c % 11 == 5;
                    boundary.set_solids(mask);
                }
                const FaceVelocity velocity = random_velocity(boundary, 1 + nx + 100 * ny);
                spectrum.compute(velocity, boundary);
                const double expected = mean_energy(velocity, boundary);
                EXPECT_NEAR(total_energy(spectrum), expected, rounding * expected);
                for (const double e : spectrum.energy()) EXPECT_GE(e, 0);
                if (ny > 1) {
                    Pool pool(1);
                    FlowReducer meter;
                    const double measured = meter.measure(velocity, boundary, pool).kinetic_energy;
                    const double area = boundary.grid().width() * boundary.grid().height();
                    EXPECT_NEAR(total_energy(spectrum) * area, measured, rounding * expected * area);
                }
            }
        }
    }
}

/// Taylor-Green vortices: the stream function sin(κ_x x) sin(κ_y y), a mode of either kind of sides, by
/// differences at the corners.
FaceVelocity mode_flow(const Boundary& boundary, double kx, double ky) {
    const double half = boundary.grid().h / 2;
    const auto psi = [&](double x, double y) { return std::sin(kx * x) * std::sin(ky * y); };
    FaceVelocity velocity = boundary.velocity();
    write_samples(velocity.u, boundary.grid(),
                  [&](WorldPoint at) { return psi(at.x, at.y + half) - psi(at.x, at.y - half); });
    write_samples(velocity.v, boundary.grid(),
                  [&](WorldPoint at) { return psi(at.x - half, at.y) - psi(at.x + half, at.y); });
    boundary.enforce(velocity);
    return velocity;
}

TEST(Spectrum, AModeLandsInItsOneShell) {
    struct Case {
        int nx, ny, m, n;
        std::size_t shell;
    };
    constexpr double h = 0.25;
    // On 24 x 16 a wave along y is half as long again in numbers of Δk.
    for (const Case& c : {Case{16, 16, 1, 1, 1}, Case{16, 16, 3, 4, 5}, Case{15, 15, 3, 4, 5},
                          Case{16, 16, 2, 7, 7}, Case{24, 16, 4, 2, 5}, Case{16, 24, 2, 4, 5}}) {
        for (const Sides& sides : test::all_sides) {
            SCOPED_TRACE(testing::Message() << c.nx << " x " << c.ny << ": " << c.m << ", " << c.n);
            const Boundary boundary({c.nx, c.ny, h}, sides);
            const double period_x = (boundary.wraps().x ? 1 : 2) * c.nx * h;
            const double period_y = (boundary.wraps().y ? 1 : 2) * c.ny * h;
            const double spacing = 2 * std::numbers::pi / std::max(period_x, period_y);
            const double kx = 2 * std::numbers::pi * c.m / period_x;
            const double ky = 2 * std::numbers::pi * c.n / period_y;
            const FaceVelocity velocity = mode_flow(boundary, kx, ky);
            Spectrum spectrum;
            spectrum.compute(velocity, boundary);
            EXPECT_DOUBLE_EQ(spectrum.spacing(), spacing);
            const auto shell = static_cast<std::size_t>(std::lround(std::hypot(kx, ky) / spacing));
            EXPECT_TRUE(shell == c.shell || sides.wraps().x != sides.wraps().y);
            ASSERT_LT(shell, spectrum.k().size());
            EXPECT_LE(std::abs(spectrum.k()[shell] - std::hypot(kx, ky)), spectrum.spacing() / 2);
            // A difference of sines is 2 sin(κh/2) cos; squares of sines and cosines have mean 1/2 each.
            const double amplitude_u = 2 * std::sin(ky * h / 2);
            const double amplitude_v = 2 * std::sin(kx * h / 2);
            const double energy = (amplitude_u * amplitude_u + amplitude_v * amplitude_v) / 8;
            for (std::size_t b = 0; b < spectrum.k().size(); ++b) {
                EXPECT_DOUBLE_EQ(spectrum.k()[b], static_cast<double>(b) * spectrum.spacing());
                EXPECT_NEAR(spectrum.energy()[b] * spectrum.spacing(), b == shell ? energy : 0,
                            sample_rounding * energy)
                    << b;
            }
        }
    }
}

TEST(Spectrum, AnEvenFlowIsInTheFirstShell) {
    const Boundary boundary({10, 7, 1}, sides::periodic);
    FaceVelocity velocity = boundary.velocity();
    velocity.u.set_all(3);
    velocity.v.set_all(-4);
    Spectrum spectrum;
    spectrum.compute(velocity, boundary);
    EXPECT_NEAR(spectrum.energy()[0] * spectrum.spacing(), 12.5, 12.5 * rounding);
    for (std::size_t b = 1; b < spectrum.k().size(); ++b) EXPECT_NEAR(spectrum.energy()[b], 0, rounding);
}

TEST(Spectrum, DoesNotReadWhatLiesInsideSolids) {
    Boundary boundary({12, 9, 1}, sides::box);
    std::vector<std::uint8_t> mask(boundary.solids().size());
    for (int j = 2; j < 5; ++j) {
        for (int i = 4; i < 8; ++i) mask[j * 12 + i] = 1;
    }
    boundary.set_solids(mask);
    FaceVelocity velocity = random_velocity(boundary, 7);
    Spectrum before, after;
    before.compute(velocity, boundary);
    velocity.u(6, 3) = 1000;
    velocity.v(6, 3) = -1000;
    after.compute(velocity, boundary);
    EXPECT_TRUE(std::equal(before.energy().begin(), before.energy().end(), after.energy().begin()));
}

}  // namespace
}  // namespace whorl
