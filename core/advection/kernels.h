// The inner loops of advection as types: each works on a short run of nodes of one row.
#pragma once

#include <span>

#include "core/grid/field.h"
#include "core/parallel/lanes.h"

namespace whorl {

/// A run of `count` nodes (i … i + count − 1, j) of a field; at most `size` where Values are filled. Loops
/// work in whole vectors: what they write for the nodes after the last one, up to the next multiple of 64
/// bytes, has no meaning.
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
    alignas(64) Values x;
    alignas(64) Values y;
};

/// Points as the cell of samples that holds them and their place in it, 0 to 1.
struct Places {
    alignas(64) Index at[Run::size];  ///< of sample (i, j) from sample (0, 0), in memory
    alignas(64) Index i[Run::size];
    alignas(64) Index j[Run::size];
    alignas(64) Values x;
    alignas(64) Values y;
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

/// Rows of what the particles of a run carry: the value and, as far as the expansion goes, the gradient and
/// the cross term, one row `stride` after the other.
struct Carried {
    static constexpr int rows = 4;
    Real* values;
    std::ptrdiff_t stride;
};

/// What one particle gives to each node of a run: where it is carried, and which particle it is.
struct Share {
    const Real* values;
    const Particle* particle;
};

/// Traces the points at `start` (cells) from each node of a run back through the flow.
/// @param dt step over cell size, time/length; negative traces forward
using TraceFn = void (*)(const Flow&, Run, Vec2 start, Real dt, Real* to_x, Real* to_y);
/// Finds the cells of a field that hold points displaced from nodes of a site. Periodic points wrap; in a box
/// they stop where ghost values do.
using LocateFn = void (*)(const Field&, Site nodes, Run, const Real* dx, const Real* dy, Places& out);
/// Interpolates a field at places.
using SampleFn = void (*)(const Field&, const Places&, int count, Values& out);
/// Finds the cells that hold displaced particles, as `LocateFn`, and takes what they carry away from there:
/// bilinear value, gradient, cross term.  [T 4.1–4.3]
/// @param fields of one site; `Carried::rows` rows of `out` each
using CarryFn = void (*)(std::span<const Field* const> fields, Site nodes, Run, const Real* dx,
                         const Real* dy, const Carried& out);
/// Adds w_s (q_s + c_s · (x_i − x_s) − q_b) of each share to each node's sum, where q_b is the bilinear value
/// at x_i^b: sums of differences keep a constant field constant to the last bit.  [T 4.1–4.3]
/// @param stride of the rows that are carried
using GatherFn = void (*)(std::span<const Share>, std::ptrdiff_t stride, int count, const Values& at_node,
                          Values& sum);
/// Limits new values to the nodes that enclose places in `q`.  [T 3.8]
/// @param at of the places
using LimitFn = void (*)(const Field& q, const Index* at, int count, const Values& first_order,
                         Values& value);

/// The inner loops that one advection uses, decided before it starts.
struct Kernels {
    TraceFn trace;
    LocateFn locate;
    SampleFn sample;
    SampleFn sample_linear;
    CarryFn carry;  ///< null where the step has no particles, as `gather`
    GatherFn gather;
    LimitFn limit;       ///< after the whole scheme
    LimitFn limit_base;  ///< inside a predictor-corrector, after its base step; null leaves it as it is
};

}  // namespace whorl
