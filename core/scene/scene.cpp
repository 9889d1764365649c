#include "core/scene/scene.h"

#include <algorithm>
#include <cmath>

#include "core/pressure/solver.h"
#include "core/scene/state.h"

namespace whorl {
namespace {

constexpr double max_cells = 1 << 23;  // a field of them takes 32 MiB, a run some tens of fields

std::string conflict_of(const SchemeSet& s, std::string_view what, const Scene& scene) {
    const std::string of = " for the " + std::string(what);
    const InterpolationTraits interpolation = s.interpolation->traits;
    if (s.affine() && !interpolation.bilinear) {
        return std::string(s.step_info().key) +
               " takes values and gradients from linear weights (thesis eq. 4.2-4.3), not from " +
               std::string(s.interpolation.key()) + of + "; set interpolation=linear";
    }
    const Grid grid = scene.grid();
    const Wraps wraps = scene.sides.wraps();
    if ((!wraps.x && grid.nx < interpolation.min_samples) ||
        (!wraps.y && grid.dimensions() == 2 && grid.ny < interpolation.min_samples)) {
        return std::string(s.interpolation.key()) + " needs at least " +
               std::to_string(interpolation.min_samples) + " cells along each side of a box (" +
               thesis_part(s.interpolation.info().source) + ")" + of;
    }
    return {};
}

}  // namespace

Grid Scene::grid() const {
    const double h = width / resolution;
    const int ny = dimensions == 1 ? 1 : std::max(2, static_cast<int>(std::lround(height / h)));
    return {resolution, ny, h};
}

std::string conflict(const Scene& scene) {
    if (const Grid grid = scene.grid(); static_cast<double>(grid.nx) * grid.ny > max_cells) {
        return std::to_string(grid.nx) + " × " + std::to_string(grid.ny) +
               " cells are more than 8388608; set a lower resolution or height";
    }
    std::string velocity = conflict_of(scene.velocity, "velocity", scene);
    if (!velocity.empty()) return velocity;
    std::string scalars = conflict_of(scene.scalars, "scalars", scene);
    if (!scalars.empty() || scene.obstacles.empty()) return scalars;
    const PressureSolverEntry& solver = pressure_solvers()[scene.pressure];
    const std::string_view reason = solver.unsupported_reason(boundary_of(scene));
    if (reason.empty()) return {};
    return std::string(solver.info.key) + " is not offered here: " + std::string(reason) +
           "; set pressure=auto";
}

}  // namespace whorl
