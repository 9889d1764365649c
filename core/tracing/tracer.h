// What a tracer is: an entry of a list, apart from its body.
#pragma once

#include <vector>

#include "core/base/id.h"
#include "core/base/scheme_info.h"
#include "core/grid/sides.h"
#include "core/parallel/isa.h"
#include "core/sampling/node_span.h"

namespace whorl {

/// The velocity as one site's nodes see it.
struct Flow {
    const FaceVelocity* velocity;
    Site site;
};

/// Traces the points at `start` (cells) from each node of a span back through the flow.
/// @param dt step over cell size, time/length; negative traces forward
using TraceFn = void (*)(const Flow&, NodeSpan, Vec2 start, Real dt, Real* to_x, Real* to_y);

/// One trace, with every point at which the tracer asks for the velocity.
struct TracedPath {
    struct Stage {
        Vec2 at;        ///< from the node, cells
        Vec2 velocity;  ///< length/time
    };
    Vec2 start{0, 0}, end{0, 0};  ///< from the node, cells
    std::vector<Stage> stages;
};

struct Tracer {
    SchemeInfo info;
    /// The loop over nodes.
    TraceFn (*trace)(Wraps, Isa);
    /// The same for one point near node (i, j).
    TracedPath (*follow)(const Flow&, Wraps, int i, int j, Vec2 start, Real dt);

    /// All tracers; the first is the default.
    static Registry<Tracer>& list();
};

/// What paths are compared with.
extern const Tracer euler, midpoint, rk4;

}  // namespace whorl
