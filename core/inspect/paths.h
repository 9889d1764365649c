// The paths of points back along the flow.
#pragma once

#include "core/inspect/explanation.h"

namespace whorl {

/// A point near a node, and the flow that carries it.
struct TraceStart {
    const FaceVelocity* velocity;
    const Boundary* boundary;
    Site site;
    int i, j;          ///< of the node
    Vec2 start{0, 0};  ///< from the node, cells
    Real dt;           ///< step over cell size, time/length; negative goes forward
};

/// By a scheme's own tracer.
Path path_of(const Tracer& tracer, const TraceStart& from);

/// In many small steps of Runge and Kutta's.
std::vector<WorldPoint> fine_path(const TraceStart& from);

}  // namespace whorl
