#include "core/inspect/paths.h"

#include <cmath>

#include "core/sampling/axis.h"

namespace whorl {
namespace {

constexpr int fine_steps = 64;

WorldPoint world(const TraceStart& from, double x, double y) {
    const double h = from.boundary->grid().h;
    return {(from.i + offset_x(from.site) + x) * h, (from.j + offset_y(from.site) + y) * h};
}

WorldPoint world(const TraceStart& from, Vec2 at) {
    return world(from, static_cast<double>(at.x), static_cast<double>(at.y));
}

}  // namespace

Path path_of(const Tracer& tracer, const TraceStart& from) {
    const TracedPath traced = tracer.follow({from.velocity, from.site}, from.boundary->wraps(), from.i,
                                            from.j, from.start, from.dt);
    Path path;
    path.start = world(from, traced.start);
    path.end = world(from, traced.end);
    for (const TracedPath::Stage& stage : traced.stages) {
        path.stages.push_back({world(from, stage.at), static_cast<double>(stage.velocity.x),
                               static_cast<double>(stage.velocity.y)});
    }
    return path;
}

std::vector<WorldPoint> fine_path(const TraceStart& from) {
    const TraceFn trace = rk4.trace(from.boundary->wraps(), best_isa());
    std::vector<WorldPoint> points;
    Vec2 at = from.start;
    const auto sensible = [](Real d) { return std::abs(d) < far; };
    for (int k = 0; k <= fine_steps && sensible(at.x) && sensible(at.y); ++k) {
        points.push_back(world(from, at));
        Displacements d{};
        trace({from.velocity, from.site}, {from.i, from.j, 1}, at, from.dt / fine_steps, d.x, d.y);
        at = Vec2(d.x[0], d.y[0]);
    }
    return points;
}

}  // namespace whorl
