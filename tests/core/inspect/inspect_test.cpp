// What is told of a step is what the step did, for every scheme, in every domain, at every node.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/inspect/explain.h"
#include "core/inspect/limiter_map.h"
#include "core/inspect/text.h"
#include "tests/core/inspect/rough_step.h"
#include "tests/support/channel.h"

namespace whorl {
namespace {

template <class Entry>
Id<Entry> any() {
    return Id<Entry>::at(*rc::gen::inRange<std::size_t>(0, Entry::list().all().size()));
}

SchemeSet any_schemes() {
    SchemeSet s;
    s.advector = any<Advector>();
    s.base = any<BaseScheme>();
    s.interpolation = s.affine() ? Id<Interpolation>("linear") : any<Interpolation>();
    s.clamped = *rc::gen::arbitrary<bool>();
    s.axis_order = any<AxisOrder>();
    s.tracer = any<Tracer>();
    s.stencil = any<StencilShape>();
    s.zeta = *rc::gen::inRange(0, SchemeSet::max_zeta + 1);
    s.weights = any<WeightKernel>();
    s.limiter = any<Limiter>();
    return s;
}

RoughStep any_step() {
    const SchemeSet schemes = any_schemes();
    const bool line = *rc::gen::inRange(0, 4) == 0;
    const Grid grid{*rc::gen::inRange(4, 40), line ? 1 : *rc::gen::inRange(4, 24),
                    *rc::gen::element(0.25, 0.7, 1.0)};
    return RoughStep(grid, test::all_sides[*rc::gen::inRange<std::size_t>(0, std::size(test::all_sides))],
                     schemes, *rc::gen::element(0.0, 0.0, 0.15), *rc::gen::element(0.2, 1.0, 3.5),
                     *rc::gen::arbitrary<unsigned>());
}

struct Node {
    FieldId quantity;
    int i, j;
};

Node any_node(const LastAdvection& last) {
    const auto quantity = *rc::gen::elementOf(advected_fields());
    const Field& q = *last.from(quantity);
    return {quantity, *rc::gen::inRange(0, q.width()), *rc::gen::inRange(0, q.height())};
}

void expect_adds_up(const Sum& sum) {
    double added = 0, size = 0, values = 0;
    for (const Term& term : sum.terms) {
        added += term.product();
        size += std::abs(term.product());
        values += std::abs(term.value);
    }
    RC_ASSERT(!sum.terms.empty());
    RC_ASSERT(!sum.title.empty());
    RC_ASSERT(!sum.equation.empty());
    if (std::abs(added - sum.total) > sum_rounding * size + weight_rounding * values)
        RC_FAIL(sum.title + " does not add up");
    if (sum.cut) {
        const Clamping& c = *sum.cut;
        RC_ASSERT(c.low <= c.high);
        RC_ASSERT(c.before == sum.total);
        const bool outside = c.before < c.low || c.before > c.high;
        RC_ASSERT(c.changed() == (outside && (!c.first_order || *c.first_order != c.before)));
        RC_ASSERT(!c.changed() || c.after == c.first_order.value_or(c.before < c.low ? c.low : c.high));
    }
    for (const Sum& part : sum.parts) expect_adds_up(part);
}

/// The limits that an explanation names are those of the nodes that it draws.
void expect_limits_of(const BaseStep& step, const Sum& sum) {
    if (!sum.cut) return;
    const auto [low, high] = std::ranges::minmax(step.enclosing, {}, &KernelNode::value);
    RC_ASSERT(sum.cut->low == low.value);
    RC_ASSERT(sum.cut->high == high.value);
}

void log(const SchemeSet& s, const Node& node) {
    RC_LOG() << s.advector.key() << " over " << s.base.key() << ", " << s.interpolation.key()
             << (s.clamped ? " clamped, " : ", ") << s.axis_order.key() << ", " << s.tracer.key() << ", "
             << s.stencil.key() << " " << s.zeta << " " << s.weights.key() << ", " << s.limiter.key() << "; "
             << node.quantity.info().key << " at " << node.i << ", " << node.j << "\n";
}

RC_GTEST_PROP(Inspect, TellsWhatTheStepDid, ()) {
    flush_denormals();
    Pool pool(1);
    const RoughStep step = any_step();
    const LastAdvection last = step.last();
    for (int k = 0; k < 6; ++k) {
        const Node node = any_node(last);
        log(last.setup.scalars, node);
        const Explanation e = explain(last, node.quantity, node.i, node.j, pool);
        // The same kernels: the same bits.
        RC_ASSERT(e.result == static_cast<double>((*last.at_present(node.quantity))(node.i, node.j)));
        RC_ASSERT(e.now == e.result);
        RC_ASSERT(e.closed || e.sum.value() == e.result);
        expect_adds_up(e.sum);
        expect_limits_of(e.steps.front(), e.sum);
        RC_ASSERT(write_text(e).find("nan") == std::string::npos);
    }
}

RC_GTEST_PROP(Inspect, LimiterMapMarksWhereExplanationsSaySo, ()) {
    flush_denormals();
    Pool pool(1);
    const RoughStep step = any_step();
    const LastAdvection last = step.last();
    const Node node = any_node(last);
    log(last.setup.scalars, node);
    Field marks;
    const int count = limiter_map(last, node.quantity, pool, marks);
    const Field& q = *last.from(node.quantity);
    RC_ASSERT(marks.same_shape(q));
    int marked = 0;
    for (int j = 0; j < q.height(); ++j) {
        for (int i = 0; i < q.width(); ++i) marked += marks(i, j) != 0 ? 1 : 0;
    }
    RC_ASSERT(marked == count);
    for (int k = 0; k < 8; ++k) {
        const int i = *rc::gen::inRange(0, q.width()), j = *rc::gen::inRange(0, q.height());
        const Explanation e = explain(last, node.quantity, i, j, pool);
        const bool expected = !e.inside() && !e.closed && e.limited();
        RC_LOG() << i << ", " << j << "\n";
        RC_ASSERT((marks(i, j) != 0) == expected);
    }
}

RC_GTEST_PROP(Inspect, DrawsThePlacesThatAreRead, ()) {
    Pool pool(1);
    const RoughStep step = any_step();
    const LastAdvection last = step.last();
    const Node node = any_node(last);
    log(last.setup.scalars, node);
    const Explanation e = explain(last, node.quantity, node.i, node.j, pool);
    const Grid& grid = step.boundary.grid();
    const double near = place_rounding * std::max(grid.width(), grid.height());
    for (const BaseStep& s : e.steps) {
        RC_ASSERT(std::hypot(s.path.start.x - e.at.x, s.path.start.y - e.at.y) <= near);
        RC_ASSERT(s.path.stages.size() >= 1u);
        RC_ASSERT(s.fine.size() == 65u);
        double dx = s.read.x - s.path.end.x, dy = s.read.y - s.path.end.y;
        const Wraps wraps = step.boundary.wraps();
        if (wraps.x) dx = std::remainder(dx, grid.width());
        if (wraps.y) dy = std::remainder(dy, grid.height());
        const bool inside_x = wraps.x || (s.path.end.x > 0 && s.path.end.x < grid.width());
        const bool inside_y = wraps.y || (s.path.end.y > 0 && s.path.end.y < grid.height());
        if (inside_x && inside_y) RC_ASSERT(std::hypot(dx, dy) <= near);
        double weights = 0;
        bool weighted = true;
        for (const KernelNode& n : s.nodes) {
            weighted = weighted && n.weight;
            weights += n.weight.value_or(0);
        }
        RC_ASSERT(!s.nodes.empty());
        RC_ASSERT(!weighted || std::abs(weights - 1) <= sum_rounding);
        double particles = 0;
        for (const StencilParticle& p : s.particles) {
            particles += p.weight;
            RC_ASSERT(std::abs(p.contribution - p.weight * p.at_node) <=
                      sum_rounding * std::abs(p.contribution));
        }
        RC_ASSERT(s.particles.empty() || std::abs(particles - 1) <= sum_rounding);
    }
}

}  // namespace
}  // namespace whorl
