// Any number of fields advect together as each does alone; a scheme's own function is what is called.
#include <gtest/gtest.h>

#include "core/interpolation/make_interpolation.h"
#include "tests/core/advection/scheme_step.h"

namespace whorl {
namespace {

TEST(Passes, MoveAnyNumberOfFieldsAsEachAlone) {
    const Stirred from({{40, 33, 1}, sides::box, true}, 1.6);
    Pool pool(2);
    const AdvectionStep step{&from.velocity, &from.boundary, &pool, 1};
    for (std::size_t a = 0; a < Advector::list().all().size(); ++a) {
        SchemeSet schemes;
        schemes.advector = Id<Advector>::at(a);
        Advection advection;
        advection.set({schemes});
        std::vector<Field> before, together;
        for (int k = 0; k < 7; ++k) {
            before.push_back(k % 2 == 0 ? from.density : from.temperature);
            before.back()(11, 7 + k) = Real(k);
            from.boundary.fill(before.back());
        }
        before.push_back(from.velocity.v);
        before.push_back(from.velocity.u);
        for (const Field& q : before) together.push_back(from.boundary.field(q.site()));
        Moved alone = together;
        std::vector<AdvectedField> fields;
        for (std::size_t k = 0; k < before.size(); ++k) fields.push_back({&before[k], &together[k]});
        advection.advect(fields, step);
        for (std::size_t k = 0; k < before.size(); ++k) advection.advect(before[k], alone[k], step);
        EXPECT_EQ(difference(together, alone), 0) << schemes.advector.key();
    }
}

/// Two samples, and not linear.
struct Overshooting {
    static constexpr SchemeInfo info{"overshooting", "", "", ""};
    static constexpr InterpolationTraits traits{
        .samples = 2, .overshoots = true, .weighted_sum = true, .order = 1};
    template <class T>
    static WHORL_INLINE T at(T q0, T q1, T t) {
        return q0 + 3 * t * (q1 - q0);
    }
};

template <bool x_first, bool clamped>
Real sampled(const Field& q, Real x, Real y) {
    CellPositions at{};
    at.at[0] = q.stride() + 1;
    at.i[0] = at.j[0] = 1;
    at.x[0] = x;
    at.y[0] = y;
    alignas(64) Values out;
    SampleLoop<Overshooting, x_first, clamped, false, false>::template run<16>(q, at, 1, out);
    return out[0];
}

TEST(SampleLoop, CallsATwoSampleSchemesOwnFunction) {
    Field q = Boundary({4, 4, 1}, sides::box).field(Site::Centre);
    q(1, 1) = 1;
    q(2, 1) = 2;
    q(1, 2) = 1;
    q(2, 2) = 5;
    // Along x: 1 + 3 · 0.5 · 1 and 1 + 3 · 0.5 · 4; then along y.
    EXPECT_EQ((sampled<true, false>(q, Real(0.5), Real(0.25))), Real(2.5 + 0.75 * 4.5));
    EXPECT_EQ((sampled<true, true>(q, Real(0.5), Real(0.25))), Real(5)) << "clamped to its nodes";
    EXPECT_EQ((sampled<true, false>(q, 0, 0)), Real(1));
}

}  // namespace
}  // namespace whorl
