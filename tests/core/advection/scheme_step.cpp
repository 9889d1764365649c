#include "tests/core/advection/scheme_step.h"

#include <cmath>

namespace whorl {
namespace {

template <class F>
void write(Field& field, F value) {
    for (int j = 0; j < field.height(); ++j) {
        for (int i = 0; i < field.width(); ++i) {
            field(i, j) = static_cast<Real>(value(i + offset_x(field.site()), j + offset_y(field.site())));
        }
    }
}

}  // namespace

Stirred::Stirred(const Domain& domain, double cfl) : boundary(domain.grid, domain.sides) {
    const Grid& grid = domain.grid;
    if (domain.obstacle) {
        std::vector<std::uint8_t> mask(static_cast<std::size_t>(grid.nx) * grid.ny, 0);
        for (int j = grid.ny / 3; j < grid.ny / 2; ++j) {
            for (int i = grid.nx / 2; i < 2 * grid.nx / 3; ++i)
                mask[static_cast<std::size_t>(j) * grid.nx + i] = 1;
        }
        boundary.set_solids(std::move(mask));
    }
    velocity = boundary.velocity();
    density = boundary.field(Site::Centre);
    temperature = boundary.field(Site::Centre);
    const double speed = cfl * grid.h;
    write(velocity.u,
          [&](double x, double y) { return speed * std::sin(0.31 * x + 0.2) * std::cos(0.23 * y); });
    write(velocity.v,
          [&](double x, double y) { return speed * std::cos(0.17 * x) * std::sin(0.29 * y + 1); });
    write(density,
          [](double x, double y) { return std::fmod(0.37 * x + 0.61 * y, 1.0) + std::sin(0.4 * x); });
    write(temperature, [](double x, double y) { return 5 + std::sin(0.21 * x * y); });
    boundary.enforce(velocity);
    boundary.fill(density);
    boundary.fill(temperature);
}

Moved move(const SchemeSet& schemes, const Stirred& from, const Ways& ways, int steps) {
    const Boundary& boundary = from.boundary;
    Moved to{boundary.field(Site::Centre), boundary.field(Site::Centre), boundary.field(Site::FaceX),
             boundary.field(Site::FaceY)};
    Advection advection;
    advection.set({.schemes = schemes,
                   .dimensions = boundary.grid().dimensions(),
                   .isa = ways.isa,
                   .shares_particles = ways.lattice});
    Pool pool(ways.threads);
    const AdvectedField fields[] = {{&from.density, &to[0]},
                                    {&from.temperature, &to[1]},
                                    {&from.velocity.u, &to[2]},
                                    {&from.velocity.v, &to[3]}};
    const AdvectionStep step{&from.velocity, &boundary, &pool, 1};
    for (int k = 0; k < steps; ++k) advection.advect(fields, step);
    return to;
}

double difference(const Moved& a, const Moved& b) {
    double worst = 0, largest = 0;
    for (std::size_t f = 0; f < a.size(); ++f) {
        for (int j = 0; j < a[f].height(); ++j) {
            for (int i = 0; i < a[f].width(); ++i) {
                const double x = static_cast<double>(a[f](i, j)), y = static_cast<double>(b[f](i, j));
                // A number that is none differs by all there is.
                worst = std::isfinite(x - y) ? std::max(worst, std::abs(x - y)) : HUGE_VAL;
                largest = std::max(largest, std::abs(y));
            }
        }
    }
    return worst / largest;
}

}  // namespace whorl
