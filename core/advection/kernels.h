// The inner loops of advection as types: each works on a short run of nodes of one row.
#pragma once

#include <span>

#include "core/grid/field.h"

namespace whorl {

/// A run of `count` nodes (i … i + count − 1, j) of a field.
struct Run {
    static constexpr int size = 64;
    int i;
    int j;
    int count;
};

/// One value for each node of a run.
using Values = Real[Run::size];

/// Points given by their way from the nodes of a run, in cells.
struct Displacements {
    Values x;
    Values y;
};

/// Points as the cell of samples that holds them and their place in it, 0 to 1.
struct Places {
    int i[Run::size];
    int j[Run::size];
    Values x;
    Values y;
};

/// The velocity as one site's nodes see it.
struct Flow {
    const FaceVelocity* velocity;
    Site site;
};

/// One fictitious particle x_s, in cells from its node x_i, and its normalised weight w_s.  [T sec. 4.1–4.2]
struct Particle {
    Vec2 offset{0, 0};
    Real weight = 1;
};

/// How much of the Taylor expansion around its departure point a particle carries to its node; `None` is a
/// scheme without particles.
enum class Expansion { None, Value, Gradient, CrossTerm };

/// Traces the points at `start` (cells) from each node of a run back through the flow.
/// @param dt step over cell size, time/length; negative traces forward
using TraceFn = void (*)(const Flow&, Run, Vec2 start, Real dt, Displacements& out);
/// Finds the cells that hold displaced points. Periodic points wrap; in a box they stop where ghost values
/// do.
using LocateFn = void (*)(const Field&, Run, const Displacements&, Places& out);
/// Interpolates a field at places.
using SampleFn = void (*)(const Field&, const Places&, int count, Values& out);
/// Adds a particle's share w_s (q_s + c_s · (x_i − x_s) − q_b) to each node's sum, where q_b is the bilinear
/// value at x_i^b: sums of differences keep a constant field constant to the last bit.  [T 4.1–4.3]
using ShareFn = void (*)(const Field&, const Places&, int count, const Particle&, const Values& at_node,
                         Values& sum);
/// Limits new values to the nodes that enclose places in `q`.  [T 3.8]
using LimitFn = void (*)(const Field& q, const Places&, int count, const Values& first_order, Values& value);

/// The inner loops that one advection uses, decided before it starts.
struct Kernels {
    TraceFn trace;
    LocateFn locate;
    SampleFn sample;
    SampleFn sample_linear;
    ShareFn share;       ///< null where the step has no particles
    LimitFn limit;       ///< after the whole scheme
    LimitFn limit_base;  ///< inside a predictor-corrector, after its base step; null leaves it as it is
};

}  // namespace whorl
