#include "core/experiments/annulus.h"

#include <cmath>

namespace whorl {

double annulus(double r) {
    const double s = (r - 6) / 2;
    return std::abs(s) < 1 ? (1 - s * s) * (1 - s * s) : 0;
}

void write_annulus(const Grid& grid, WorldPoint centre, Field& q) {
    write_samples(q, grid, [&](WorldPoint at) {
        const double dx = std::remainder(at.x - centre.x, grid.width());
        const double dy = grid.dimensions() == 1 ? 0 : std::remainder(at.y - centre.y, grid.height());
        return annulus(std::hypot(dx, dy));
    });
}

void thesis_test(Scene& scene) {
    scene.width = scene.height = 40;
    scene.resolution = 40;
    scene.sides = sides::periodic;
    scene.dt = 1.0 / 60;
    scene.steps = 1200;
}

void write_uniform_flow(double u, double v, FaceVelocity& velocity) {
    velocity.u.set_all(static_cast<Real>(u));
    velocity.v.set_all(static_cast<Real>(v));
}

}  // namespace whorl
