// Zalesak's slotted disk, turned once as a solid body.  [Zalesak 1979]
#include <cmath>
#include <numbers>

#include "core/experiments/experiment.h"

namespace whorl {
namespace {

constexpr double turn = 20;  // time of one turn
// The paper's shape in a domain of 100, here of 40.
constexpr double radius = 6;
constexpr double slot_width = 2;
constexpr double slot_top_above_centre = 4;
constexpr WorldPoint centre{20, 30};

void flow(double, const Grid& grid, FaceVelocity& velocity) {
    constexpr double omega = 2 * std::numbers::pi / turn;
    for (int j = 0; j < velocity.u.height(); ++j) {
        for (int i = 0; i < velocity.u.width(); ++i) {
            velocity.u(i, j) =
                static_cast<Real>(-omega * (world(velocity.u, grid, i, j).y - grid.height() / 2));
        }
    }
    for (int j = 0; j < velocity.v.height(); ++j) {
        for (int i = 0; i < velocity.v.width(); ++i) {
            velocity.v(i, j) =
                static_cast<Real>(omega * (world(velocity.v, grid, i, j).x - grid.width() / 2));
        }
    }
}

void write_disk(const Grid& grid, Field& q) {
    for (int j = 0; j < q.height(); ++j) {
        for (int i = 0; i < q.width(); ++i) {
            const auto [x, y] = world(q, grid, i, j);
            const bool disk = std::hypot(x - centre.x, y - centre.y) < radius;
            const bool slot = std::abs(x - centre.x) < slot_width / 2 && y < centre.y + slot_top_above_centre;
            q(i, j) = disk && !slot ? Real(1) : Real(0);
        }
    }
}

bool exact(double time, double dt, const Grid& grid, Field& q) {
    if (std::abs(std::remainder(time, turn)) > dt / 2) return false;
    write_disk(grid, q);
    return true;
}

}  // namespace

Experiment zalesak() {
    return {.info = {"zalesak", "Zalesak's disk", "Zalesak 1979",
                     "A slotted disk turns once as a solid body: exact at step 1200."},
            .setup =
                [](Scene& s) {
                    s.width = s.height = 40;
                    s.resolution = 100;
                    s.sides = Sides::of<Box>();
                    s.steps = 1200;
                },
            .start = [](State& s) { write_disk(s.grid(), s.density); },
            .flow = flow,
            .exact = exact};
}

}  // namespace whorl
