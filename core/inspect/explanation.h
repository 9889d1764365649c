// Why a node holds its value: a plain value, to draw and to write.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/phases/last_advection.h"
#include "core/scene/state.h"

namespace whorl {

/// One product of a sum.
struct Term {
    std::string label;  ///< of the value
    double weight = 1;
    double value = 0;

    double product() const { return weight * value; }
};

/// The slopes of a cubic at the ends of its interval, per cell, before and after they were limited.
/// [T 3.13–3.23]
struct CubicSlopes {
    double D = 0;  ///< q_{i+1} − q_i
    double left = 0, right = 0;
    double limited_left = 0, limited_right = 0;
    std::string equation{};  ///< where the thesis has that limit, if there is one

    // Not finite where the interval is flat.
    double alpha() const { return left / D; }
    double beta() const { return right / D; }
    double limited_alpha() const { return limited_left / D; }
    double limited_beta() const { return limited_right / D; }
    bool changed() const { return left != limited_left || right != limited_right; }
};

/// What a limiter made of a value.
struct Clamping {
    std::string by, equation;
    double low = 0, high = 0;           ///< of the enclosing nodes
    std::optional<double> first_order;  ///< what stands by, where a limiter may fall back on it
    double before = 0, after = 0;

    bool changed() const { return before != after; }
};

/// A value written out. Its terms add up to `total`, to rounding.
struct Sum {
    std::string title;     ///< what it is the value of
    std::string equation;  ///< where the thesis has it, or what else is its source
    std::vector<Term> terms;
    double total = 0;     ///< as the solver rounds it
    std::string units{};  ///< of labels, weights and values, where they are not all those of the field
    std::optional<CubicSlopes> slopes{};
    std::optional<Clamping> cut{};
    std::vector<Sum> parts{};  ///< where values of terms come from

    double value() const { return cut ? cut->after : total; }
};

/// A path along the frozen flow, in length units. Periodic ones are not wrapped.
struct Path {
    /// Where a tracer asked for the velocity, and what it was told.
    struct Stage {
        WorldPoint at;
        double u, v;  ///< length/time
    };
    WorldPoint start{}, end{};
    std::vector<Stage> stages;
};

/// A node that an interpolation reads.
struct KernelNode {
    int i, j;       ///< may be of the ghost border
    WorldPoint at;  ///< length
    double value;
    std::optional<double> weight;  ///< nothing where the scheme is no weighted sum
};

/// What one fictitious particle x_s brings to its node.  [T 4.1–4.3]
struct StencilParticle {
    Path path;
    double weight;                          ///< normalised
    double value;                           ///< q_s at its departure point
    double gradient_x = 0, gradient_y = 0;  ///< c_s, per cell
    double cross = 0;                       ///< c_xy, per cell²
    double at_node;                         ///< carried on to the node
    double contribution;                    ///< weight × at_node
};

/// One step A of the base scheme at one node, as it is drawn.
struct BaseStep {
    std::string title;
    Path path;                     ///< of the node, by the scheme's tracer
    Path euler, midpoint;          ///< to compare
    std::vector<WorldPoint> fine;  ///< the same path in many small steps: as good as exact
    /// The place that is read: the departure point, wrapped or brought back to where values are.
    WorldPoint read{};
    int i = 0, j = 0;                       ///< of the sample below and to the left of it
    double x = 0, y = 0;                    ///< its place from there, cells
    std::vector<KernelNode> nodes;          ///< that the interpolation reads there
    std::array<KernelNode, 4> enclosing{};  ///< that limits are taken from
    std::vector<StencilParticle> particles;
    double weight_sum = 1;  ///< of the particles' weights before they were normalised
};

/// The steps of a predictor-corrector.  [T alg 3.2, 3.3]
struct Correction {
    double start;    ///< qⁿ
    double forward;  ///< q̂ⁿ⁺¹
    double back;     ///< q̂ⁿ
    double error;    ///< e = (q̂ⁿ − qⁿ)/2
};

struct Explanation {
    FieldId quantity{};
    int i = 0, j = 0;  ///< of the node that was asked for
    /// Of the node that is explained: the same, or for one in a solid the nearest that fluid touches, whose
    /// value it takes.
    int of_i = 0, of_j = 0;
    bool closed = false;          ///< that node is a face beside a solid: no velocity across
    WorldPoint at{};              ///< of that node, length
    std::vector<BaseStep> steps;  ///< forward; and for predictor-correctors back, and again
    std::optional<Correction> correction;
    Sum sum;
    double result = 0;  ///< what the advection gave the node, walls heeded
    double now = 0;     ///< what it holds at present, see LastAdvection::now

    bool inside() const { return of_i != i || of_j != j; }
    /// Whether a limiter changed the node's value on the way.
    bool limited() const;
};

}  // namespace whorl
