// What is told of a step is what the step did, for every scheme, in every domain, at every node.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "core/advection/advection.h"
#include "core/base/error.h"
#include "core/inspect/explain.h"
#include "core/inspect/limiter_map.h"
#include "core/inspect/text.h"
#include "core/inspect/walls.h"
#include "core/scene/parameters.h"
#include "core/scene/step_order.h"
#include "core/session/player.h"
#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"
#include "tests/support/channel.h"

namespace whorl {
namespace {

constexpr double epsilon = static_cast<double>(std::numeric_limits<Real>::epsilon());
/// The solver adds up to 81 particles as differences from one of them, each with a rounding error.
constexpr double sum_rounding = 128 * epsilon;
/// An interpolation's weights are found from samples of 1, with an error of that size however small they are.
constexpr double weight_rounding = 8 * epsilon;
/// A displacement and its cell are each rounded a few times, at the size of the domain.
constexpr double place_rounding = 64 * epsilon;

Real uniform(std::mt19937& random, double low, double high) {
    return static_cast<Real>(std::uniform_real_distribution<double>(low, high)(random));
}

void scatter(Field& field, std::mt19937& random, double low, double high) {
    for (int j = 0; j < field.height(); ++j) {
        for (int i = 0; i < field.width(); ++i) field(i, j) = uniform(random, low, high);
    }
}

/// Rough fields, and what one step of a scheme makes of them, as a simulation orders it.
struct Step1 {
    Boundary boundary;
    FaceVelocity velocity, next_velocity;
    Field density, temperature, next_density, next_temperature;
    AdvectionSetup setup;

    Step1(const Grid& grid, const Sides& sides, const SchemeSet& schemes, double solid_share, double cfl,
          unsigned seed)
        : boundary(grid, sides) {
        std::mt19937 random(seed);
        std::vector<std::uint8_t> mask(static_cast<std::size_t>(grid.nx) * grid.ny);
        for (auto& cell : mask) cell = uniform(random, 0, 1) < solid_share ? 1 : 0;
        boundary.set_solids(mask);
        velocity = boundary.velocity();
        density = boundary.field(Site::Centre);
        temperature = density;
        scatter(velocity.u, random, -cfl * grid.h, cfl * grid.h);
        if (grid.dimensions() == 2) scatter(velocity.v, random, -cfl * grid.h, cfl * grid.h);
        scatter(density, random, 0, 1);
        scatter(temperature, random, 5, 50);
        boundary.enforce(velocity);
        boundary.fill(density);
        boundary.fill(temperature);
        next_velocity = boundary.velocity();
        next_density = next_temperature = boundary.field(Site::Centre);
        setup = {schemes, schemes, 1, seed};
        Advection advection;
        advection.set({schemes, grid.dimensions(), seed});
        const AdvectedField fields[] = {{&density, &next_density},
                                        {&temperature, &next_temperature},
                                        {&velocity.u, &next_velocity.u},
                                        {&velocity.v, &next_velocity.v}};
        Pool pool(1);
        advection.advect(fields, {&velocity, &boundary, &pool, setup.dt});
        boundary.enforce(next_velocity);
    }
    LastAdvection last() const {
        return {setup,
                &boundary,
                &velocity,
                {&density, &temperature, &velocity.u, &velocity.v},
                {&next_density, &next_temperature, &next_velocity.u, &next_velocity.v}};
    }
};

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

Step1 any_step() {
    const SchemeSet schemes = any_schemes();
    const bool line = *rc::gen::inRange(0, 4) == 0;
    const Grid grid{*rc::gen::inRange(4, 40), line ? 1 : *rc::gen::inRange(4, 24),
                    *rc::gen::element(0.25, 0.7, 1.0)};
    return Step1(grid, test::all_sides[*rc::gen::inRange<std::size_t>(0, std::size(test::all_sides))],
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
        const Cut& c = *sum.cut;
        RC_ASSERT(c.low <= c.high);
        RC_ASSERT(c.before == sum.total);
        const bool outside = c.before < c.low || c.before > c.high;
        RC_ASSERT(c.acted() == (outside && (!c.first_order || *c.first_order != c.before)));
        RC_ASSERT(!c.acted() || c.after == c.first_order.value_or(c.before < c.low ? c.low : c.high));
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
    const Step1 step = any_step();
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
    const Step1 step = any_step();
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
    const Step1 step = any_step();
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

TEST(Inspect, WaysOfTracersAreThose) {
    SchemeSet schemes;
    schemes.tracer = Id<Tracer>("rk4");
    const Step1 step({20, 20, 0.5}, sides::periodic, schemes, 0, 0.4, 3);
    Pool pool(1);
    const Explanation e = explain(step.last(), field::density, 9, 9, pool);
    const BaseStep& s = e.steps.at(0);
    EXPECT_EQ(s.euler.stages.size(), 1u);
    EXPECT_EQ(s.midpoint.stages.size(), 2u);
    EXPECT_EQ(s.path.stages.size(), 4u);
    // x^b = x − Δt u(x)  [T 3.3]
    EXPECT_NEAR(s.euler.end.x, e.at.x - s.euler.stages[0].u, place_rounding * 10);
    EXPECT_NEAR(s.euler.end.y, e.at.y - s.euler.stages[0].v, place_rounding * 10);
    // x^m = x − ½Δt u(x), x^b = x − Δt u(x^m)  [T 3.4–3.5]
    EXPECT_NEAR(s.midpoint.stages[1].at.x, e.at.x - s.midpoint.stages[0].u / 2, place_rounding * 10);
    EXPECT_NEAR(s.midpoint.end.y, e.at.y - s.midpoint.stages[1].v, place_rounding * 10);
}

TEST(Inspect, ShowsSlopesThatFritschCarlsonLimits) {
    SchemeSet schemes;
    schemes.interpolation = Id<Interpolation>("fritsch-carlson");
    Step1 step({8, 1, 1}, sides::periodic, schemes, 0, 0, 1);
    // A foot and a step: δ_i = 2.5, D = 0.5.  [T 3.13–3.14]
    const Real samples[] = {0, 0, 4.5F, 5, 10, 10, 10, 0};
    std::copy(std::begin(samples), std::end(samples), step.density.row(0));
    step.boundary.fill(step.density);
    step.velocity.u.set_all(Real(-0.5));
    Pool pool(1);
    const Explanation e = explain(step.last(), field::density, 2, 0, pool);
    ASSERT_TRUE(e.sum.slopes);
    EXPECT_EQ(e.sum.slopes->D, 0.5);
    EXPECT_EQ(e.sum.slopes->left, 2.5);
    EXPECT_EQ(e.sum.slopes->right, 2.75);
    EXPECT_EQ(e.sum.slopes->alpha(), 5);
    EXPECT_EQ(e.sum.slopes->beta(), 5.5);
    const double a = e.sum.slopes->limited_alpha(), b = e.sum.slopes->limited_beta();
    EXPECT_NEAR(a * a + b * b, 9, 9 * sum_rounding) << "on the circle [T 3.20]";
    EXPECT_NEAR(a / b, 5 / 5.5, sum_rounding) << "towards the origin [T 3.22]";
    EXPECT_NE(e.sum.equation.find("3.20"), std::string::npos);
}

TEST(Inspect, NamesTheEquationsOfTheThesis) {
    const auto sum = [](const char* advector, const char* base = "semi-lagrangian", int rows = 9) {
        SchemeSet schemes;
        schemes.advector = Id<Advector>(advector);
        schemes.base = Id<BaseScheme>(base);
        const Step1 step({9, rows, 1}, sides::periodic, schemes, 0, 0.5, 3);
        Pool pool(1);
        return explain(step.last(), field::density, 4, rows / 2, pool).sum;
    };
    const auto equation = [&](const char* advector) { return sum(advector).equation; };
    EXPECT_EQ(equation("semi-lagrangian"), "thesis eq. 3.6–3.7, 3.11");
    EXPECT_EQ(equation("maccormack"), "thesis alg. 3.3, eq. 3.26");
    EXPECT_EQ(equation("bfecc"), "thesis alg. 3.2, step 5");
    EXPECT_EQ(equation("aslam"), "thesis alg. 4.1, eq. 4.1–4.3");
    EXPECT_EQ(equation("aslam-0"), "thesis eq. 5.8");
    EXPECT_EQ(equation("aslam-bilinear"), "after thesis sec. 6.1");
    EXPECT_EQ(sum("semi-lagrangian", "semi-lagrangian", 1).equation, "thesis eq. 3.6, 3.11") << "of one axis";
    // Predictor-correctors over ASLAM: its update, and the clamp that the thesis tries out.
    EXPECT_EQ(sum("maccormack", "aslam").parts[0].equation, "thesis alg. 4.1, eq. 4.1–4.3");
    EXPECT_EQ(sum("maccormack", "aslam-clamped").parts[0].equation, "thesis alg. 4.1, eq. 4.1–4.3");
    EXPECT_EQ(sum("maccormack", "aslam-clamped").parts[0].cut->equation, "thesis sec. 5.5");
    // Clamps.
    EXPECT_EQ(sum("maccormack").cut->equation, "thesis sec. 3.2, eq. 3.8");
    EXPECT_EQ(sum("aslam").cut->equation, "thesis ch. 4, after eq. 4.3");
    EXPECT_EQ(sum("maccormack", "aslam").cut->equation, "thesis sec. 3.2, eq. 3.8");
    // A particle's guess is the bracket of the update; without gradients, what it reads.
    EXPECT_EQ(sum("aslam").parts[1].equation, "thesis eq. 4.1, its bracket; q_s and ∂q: eq. 4.2–4.3");
    EXPECT_EQ(sum("aslam-0").parts[1].equation, "thesis eq. 4.3");
    EXPECT_EQ(sum("aslam-bilinear").parts[1].equation,
              "thesis eq. 4.1, its bracket; q_s and ∂q: eq. 4.2–4.3; c_xy after sec. 6.1");
}

TEST(Inspect, NamesTheSourceOfEachLimitOfSlopes) {
    const auto told = [](const char* interpolation) {
        SchemeSet schemes;
        schemes.interpolation = Id<Interpolation>(interpolation);
        Step1 step({8, 1, 1}, sides::periodic, schemes, 0, 0, 1);
        // A dent beside a steep step: δ_i has the wrong sign, δ_{i+1} is beyond 3 D.
        const Real samples[] = {0, 2, 1, 1.5F, 10, 10, 10, 0};
        std::copy(std::begin(samples), std::end(samples), step.density.row(0));
        step.boundary.fill(step.density);
        step.velocity.u.set_all(Real(-0.5));
        Pool pool(1);
        const Explanation e = explain(step.last(), field::density, 2, 0, pool);
        EXPECT_TRUE(e.sum.slopes->acted()) << interpolation;
        EXPECT_NE(write_text(e).find("limited: "), std::string::npos);
        EXPECT_NE(write_text(e).find("[" + e.sum.slopes->equation + "]"), std::string::npos);
        return e.sum.slopes->equation;
    };
    EXPECT_EQ(told("monotone-catmull-rom"), "thesis eq. 3.15, sec. A.1");
    EXPECT_EQ(told("fritsch-carlson"), "thesis eq. 3.15, 3.20–3.23");
    EXPECT_EQ(told("fritsch-carlson-square"), "thesis eq. 3.15, sec. A.3");
}

TEST(Inspect, KnowsWallsAndWhatHoldsNoValueOfItsOwn) {
    Boundary boundary({6, 4, 1}, sides::box);
    std::vector<std::uint8_t> mask(24, 0);
    mask[1 * 6 + 3] = 1;
    boundary.set_solids(mask);
    const WallRules centres(boundary, Site::Centre), faces(boundary, Site::FaceX);
    EXPECT_TRUE(centres.free(2, 1));
    EXPECT_FALSE(centres.free(3, 1));
    EXPECT_NE(centres.source(3, 1), std::pair(3, 1));
    EXPECT_FALSE(centres.closed(3, 1));
    EXPECT_TRUE(faces.closed(0, 0)) << "the box's own wall";
    EXPECT_TRUE(faces.closed(3, 1));
    EXPECT_EQ(faces.source(3, 1), std::pair(3, 1));
    EXPECT_TRUE(faces.free(3, 2));
}

TEST(Inspect, RefusesWhatThereIsNot) {
    const Step1 step({9, 7, 1}, sides::box, {}, 0, 0.5, 3);
    LastAdvection last = step.last();
    Pool pool(1);
    EXPECT_THROW(explain(last, field::density, 9, 0, pool), InputError);
    EXPECT_NO_THROW(explain(last, field::u, 9, 0, pool));
    EXPECT_THROW(explain(last, field::u, 0, -1, pool), InputError);
    last.before[2] = nullptr;
    EXPECT_THROW(explain(last, field::u, 0, 0, pool), InputError);
    Field marks;
    EXPECT_EQ(limiter_map(last, field::u, pool, marks), 0);
}

/// The last step of a running scene.
void expect_told(const Simulation& simulation, bool projected_after) {
    const auto last = simulation.last_advection();
    ASSERT_TRUE(last);
    Pool pool(1);
    for (std::size_t k = 0; k < fields().size(); ++k) {
        const auto quantity = FieldId(k);
        const Field* q = last->from(quantity);
        if (q == nullptr) continue;
        const bool scalar = q->site() == Site::Centre;
        for (int j = 0; j < q->height(); j += 3) {
            for (int i = 0; i < q->width(); i += 2) {
                const Explanation e = explain(*last, quantity, i, j, pool);
                if (projected_after && !scalar) continue;  // that changes what advection gave
                EXPECT_EQ(e.result, e.now) << quantity.info().key << " at " << i << ", " << j;
            }
        }
    }
}

TEST(Inspect, TellsTheLastStepOfARun) {
    for (const char* order : {"order=thesis", "order=smoke"}) {
        for (const char* advector : {"advector=maccormack", "advector=bfecc", "advector=aslam"}) {
            for (const bool linked : {true, false}) {
                Scene scene = scene_of(experiment("plume"));
                for (const char* s : {"resolution=20", order, advector}) set_parameter(scene, s);
                if (!linked) set_parameter(scene, "velocity.zeta=3");
                scene.obstacles = {{.x = 20, .y = 15, .radius = 4}};
                Pool pool(2);
                Simulation simulation(scene, pool);
                EXPECT_FALSE(simulation.last_advection()) << "no step yet";
                for (int k = 0; k < 40; ++k) simulation.step();
                expect_told(simulation, step_orders().all()[scene.order]->info.key == "smoke");
            }
        }
    }
}

TEST(Inspect, TellsTheLastStepOfEveryExperiment) {
    for (const Experiment& e : experiments()) {
        Scene scene = scene_of(e);
        if (scene.dimensions == 2) set_parameter(scene, "resolution=16");
        Pool pool(1);
        Simulation simulation(scene, pool);
        for (int k = 0; k < 5; ++k) simulation.step();
        expect_told(simulation, step_orders().all()[scene.order]->info.key == "smoke");
        EXPECT_EQ(simulation.last_advection()->from(field::u) == nullptr, e.flow != nullptr);
    }
}

TEST(Inspect, SaysNothingOfFieldsThatWereChangedSince) {
    const auto stepped = [](const char* name, Pool& pool) {
        Scene scene = scene_of(experiment(name));
        set_parameter(scene, "resolution=16");
        Simulation simulation(scene, pool);
        simulation.step();
        return simulation;
    };
    Pool pool(1);
    const auto wall = [](Simulation& s) { s.apply(ObstacleStroke{.along = {8, 20, 30, 26}, .radius = 3}); };
    const auto smoke = [](Simulation& s) {
        s.apply(SmokeStroke{.along = {5, 5, 30, 22},
                            .radius = 3,
                            .amounts = {{field::density, 1}},
                            .push = 1,
                            .velocity_x = 20});
    };
    const auto resolve = [](Simulation& s) {
        Scene scene = s.scene();
        set_parameter(scene, "resolution=20");
        s.set(scene);
    };
    const auto restart = [](Simulation& s) { s.restart(); };
    const auto restore = [](Simulation& s) { s.restore(s.checkpoint()); };
    for (const std::function<void(Simulation&)>& change :
         std::initializer_list<std::function<void(Simulation&)>>{wall, resolve, restart, restore}) {
        Simulation s = stepped("plume", pool);
        ASSERT_TRUE(s.last_advection());
        change(s);
        EXPECT_FALSE(s.last_advection());
        s.step();
        expect_told(s, false);
    }
    Simulation pushed = stepped("rotation", pool);
    smoke(pushed);
    EXPECT_FALSE(pushed.last_advection()) << "the flow that moved the density was pushed";
    // What the advection began with is still there; the density has changed since.
    Simulation plume = stepped("plume", pool);
    smoke(plume);
    ASSERT_TRUE(plume.last_advection());
    const Explanation e = explain(*plume.last_advection(), field::density, 6, 5, pool);
    EXPECT_NE(e.now, e.result);
    // Other schemes act on the next step, and do not change what the last one did.
    Scene other = plume.scene();
    set_parameter(other, "advector=aslam");
    plume.set(other);
    EXPECT_EQ(explain(*plume.last_advection(), field::density, 6, 5, pool).result, e.result);
}

TEST(Inspect, WritesTheSumAsText) {
    SchemeSet schemes;
    schemes.advector = Id<Advector>("maccormack");
    const Step1 step({9, 7, 1}, sides::periodic, schemes, 0, 0.8, 3);
    Pool pool(1);
    const std::string text = write_text(explain(step.last(), field::density, 4, 3, pool));
    for (const char* words :
         {"Density at (4, 3): ", "forward: (4.5, 3.5) → (", "back again: ", "many small steps (",
          "ρ after advection = ", "thesis alg. 3.3, eq. 3.26", "ρ forward = ", "thesis eq. 3.6–3.7, 3.11",
          "limiter: Clamp: the enclosing nodes hold ", "thesis sec. 3.2, eq. 3.8"}) {
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    }
}

}  // namespace
}  // namespace whorl
