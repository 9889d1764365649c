// A step of a scheme over rough fields, and how exactly numbers told of it can be compared.
#pragma once

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "core/advection/advection.h"
#include "core/phases/last_advection.h"

namespace whorl {

inline constexpr double epsilon = static_cast<double>(std::numeric_limits<Real>::epsilon());
/// The solver adds up to 81 particles as differences from one of them, each with a rounding error.
inline constexpr double sum_rounding = 128 * epsilon;
/// An interpolation's weights are found from samples of 1, with an error of that size however small they are.
inline constexpr double weight_rounding = 8 * epsilon;
/// A displacement and its cell are each rounded a few times, at the size of the domain.
inline constexpr double place_rounding = 64 * epsilon;

inline Real uniform(std::mt19937& random, double low, double high) {
    return static_cast<Real>(std::uniform_real_distribution<double>(low, high)(random));
}

inline void scatter(Field& field, std::mt19937& random, double low, double high) {
    for (int j = 0; j < field.height(); ++j) {
        for (int i = 0; i < field.width(); ++i) field(i, j) = uniform(random, low, high);
    }
}

/// Rough fields, and what one step of a scheme makes of them, as a simulation orders it.
struct RoughStep {
    Boundary boundary;
    FaceVelocity velocity, next_velocity;
    Field density, temperature, next_density, next_temperature;
    AdvectionSetup setup;

    RoughStep(const Grid& grid, const Sides& sides, const SchemeSet& schemes, double solid_share, double cfl,
              unsigned seed)
        : boundary(grid, sides) {
        std::mt19937 random(seed);
        std::vector<std::uint8_t> mask(static_cast<std::size_t>(grid.nx) * grid.ny);
        for (auto& cell : mask) cell = uniform(random, 0, 1) < solid_share ? 1 : 0;
        boundary.set_solids(mask);
        velocity = boundary.velocity();
        density = boundary.field(Site::Centre);
        temperature = density;
        scatter(velocity.u, random, -cfl * grid.h, cfl * grid.h);
        if (grid.dimensions() == 2) scatter(velocity.v, random, -cfl * grid.h, cfl * grid.h);
        scatter(density, random, 0, 1);
        scatter(temperature, random, 5, 50);
        boundary.enforce(velocity);
        boundary.fill(density);
        boundary.fill(temperature);
        next_velocity = boundary.velocity();
        next_density = next_temperature = boundary.field(Site::Centre);
        setup = {schemes, schemes, 1, seed};
        Advection advection;
        advection.set({schemes, grid.dimensions(), seed});
        const AdvectedField fields[] = {{&density, &next_density},
                                        {&temperature, &next_temperature},
                                        {&velocity.u, &next_velocity.u},
                                        {&velocity.v, &next_velocity.v}};
        Pool pool(1);
        advection.advect(fields, {&velocity, &boundary, &pool, setup.dt});
        boundary.enforce(next_velocity);
    }
    LastAdvection last() const {
        return {setup,
                &boundary,
                &velocity,
                {&density, &temperature, &velocity.u, &velocity.v},
                {&next_density, &next_temperature, &next_velocity.u, &next_velocity.v}};
    }
};

}  // namespace whorl
