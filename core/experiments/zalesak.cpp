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
    write_samples(velocity.u, grid, [&](WorldPoint at) { return -omega * (at.y - grid.height() / 2); });
    write_samples(velocity.v, grid, [&](WorldPoint at) { return omega * (at.x - grid.width() / 2); });
}

void write_disk(const Grid& grid, Field& q) {
    write_samples(q, grid, [](WorldPoint at) {
        const bool disk = std::hypot(at.x - centre.x, at.y - centre.y) < radius;
        const bool slot =
            std::abs(at.x - centre.x) < slot_width / 2 && at.y < centre.y + slot_top_above_centre;
        return disk && !slot ? 1.0 : 0.0;
    });
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
                    s.sides = sides::box;
                    s.steps = 1200;
                },
            .start = [](State& s) { write_disk(s.grid(), s.density()); },
            .flow = flow,
            .exact = exact,
            .known = "every 20 units of time: steps 1200, 2400 … of Δt = 1/60"};
}

}  // namespace whorl
