// What an explanation names: paths, slopes, equations, limits and walls.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/inspect/explain.h"
#include "core/inspect/limiter_map.h"
#include "core/inspect/text.h"
#include "core/inspect/walls.h"
#include "tests/core/inspect/rough_step.h"

namespace whorl {
namespace {

TEST(Inspect, WaysOfTracersAreThose) {
    SchemeSet schemes;
    schemes.tracer = Id<Tracer>("rk4");
    const RoughStep step({20, 20, 0.5}, sides::periodic, schemes, 0, 0.4, 3);
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
    RoughStep step({8, 1, 1}, sides::periodic, schemes, 0, 0, 1);
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
        const RoughStep step({9, rows, 1}, sides::periodic, schemes, 0, 0.5, 3);
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
        RoughStep step({8, 1, 1}, sides::periodic, schemes, 0, 0, 1);
        // A dent beside a steep step: δ_i has the wrong sign, δ_{i+1} is beyond 3 D.
        const Real samples[] = {0, 2, 1, 1.5F, 10, 10, 10, 0};
        std::copy(std::begin(samples), std::end(samples), step.density.row(0));
        step.boundary.fill(step.density);
        step.velocity.u.set_all(Real(-0.5));
        Pool pool(1);
        const Explanation e = explain(step.last(), field::density, 2, 0, pool);
        EXPECT_TRUE(e.sum.slopes->changed()) << interpolation;
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
    const RoughStep step({9, 7, 1}, sides::box, {}, 0, 0.5, 3);
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

TEST(Inspect, WritesTheSumAsText) {
    SchemeSet schemes;
    schemes.advector = Id<Advector>("maccormack");
    const RoughStep step({9, 7, 1}, sides::periodic, schemes, 0, 0.8, 3);
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
