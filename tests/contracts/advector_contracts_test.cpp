// What every advector must keep, whatever it is combined with: the same promises over the whole registry.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/advection/advection.h"

namespace whorl {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
/// A value passes through a few dozen operations a step.
constexpr Real rounding = 64 * epsilon;

struct Combination {
    SchemeSet schemes;
    bool periodic;
    std::string name;
};

std::string word(std::string_view key) {
    std::string text(key);
    std::replace(text.begin(), text.end(), '-', '_');
    return text;
}

/// Every advector × interpolation × tracer × limiter that go together, in a box and periodic.
std::vector<Combination> combinations() {
    std::vector<Combination> all;
    for (std::size_t a = 0; a < Advector::list().all().size(); ++a) {
        for (std::size_t i = 0; i < Interpolation::list().all().size(); ++i) {
            for (std::size_t t = 0; t < Tracer::list().all().size(); ++t) {
                for (std::size_t l = 0; l < Limiter::list().all().size(); ++l) {
                    SchemeSet s;
                    s.advector = Id<Advector>::at(a);
                    s.interpolation = Id<Interpolation>::at(i);
                    s.tracer = Id<Tracer>::at(t);
                    s.limiter = Id<Limiter>::at(l);
                    if (s.affine() && i > 0) continue;
                    if (!s.advector->traits.limited && l > 0) continue;
                    for (const bool periodic : {false, true}) {
                        all.push_back({s, periodic,
                                       word(s.advector.key()) + "_" + word(s.interpolation.key()) + "_" +
                                           word(s.tracer.key()) + "_" + word(s.limiter.key()) +
                                           (periodic ? "_periodic" : "_box")});
                    }
                }
            }
        }
    }
    return all;
}

/// Every stencil × ζ × weights for the ASLAM family, alone and as a base.
std::vector<Combination> stencil_combinations() {
    std::vector<Combination> all;
    const auto add = [&](SchemeSet s, const std::string& name) {
        for (std::size_t k = 0; k < StencilShape::list().all().size(); ++k) {
            for (std::size_t w = 0; w < WeightKernel::list().all().size(); ++w) {
                for (int zeta = 0; zeta <= SchemeSet::max_zeta; ++zeta) {
                    s.stencil = Id<StencilShape>::at(k);
                    s.weights = Id<WeightKernel>::at(w);
                    s.zeta = zeta;
                    all.push_back({s, true,
                                   name + "_" + word(s.stencil.key()) + "_" + word(s.weights.key()) +
                                       "_zeta" + std::to_string(zeta)});
                }
            }
        }
    };
    for (std::size_t a = 0; a < Advector::list().all().size(); ++a) {
        SchemeSet s;
        s.advector = Id<Advector>::at(a);
        if (s.affine()) add(s, word(s.advector.key()));
        if (!s.predictor_corrector()) continue;
        for (std::size_t b = 0; b < BaseScheme::list().all().size(); ++b) {
            s.base = Id<BaseScheme>::at(b);
            if (s.affine()) add(s, word(s.advector.key()) + "_over_" + word(s.base.key()));
        }
    }
    return all;
}

class AdvectorContract : public testing::TestWithParam<Combination> {
  protected:
    static constexpr int nx = 13, ny = 10;  // odd and even, and not square
    Pool pool{1};
    Boundary boundary{Grid{nx, ny, 0.5}, GetParam().periodic ? sides::periodic : sides::box};
    std::mt19937 random{7};

    Field random_field() {
        Field q = boundary.field(Site::Centre);
        std::uniform_real_distribution<double> uniform(0, 1);
        for (int j = 0; j < q.height(); ++j) {
            for (int i = 0; i < q.width(); ++i) q(i, j) = static_cast<Real>(uniform(random));
        }
        boundary.fill(q);
        return q;
    }
    /// Random, not smooth, and several cells a step.
    FaceVelocity random_velocity() {
        FaceVelocity velocity = boundary.velocity();
        std::uniform_real_distribution<double> uniform(-3, 3);
        for (Field* field : {&velocity.u, &velocity.v}) {
            for (int j = 0; j < field->height(); ++j) {
                for (int i = 0; i < field->width(); ++i) (*field)(i, j) = static_cast<Real>(uniform(random));
            }
        }
        boundary.enforce(velocity);
        return velocity;
    }
    Field advected(const Field& q, const FaceVelocity& velocity, double dt) {
        Advection advection;
        advection.set({GetParam().schemes});
        Field out = boundary.field(q.site());
        advection.advect(q, out, {&velocity, &boundary, &pool, dt});
        return out;
    }
};

TEST_P(AdvectorContract, ConstantStaysConstant) {
    Field q = boundary.field(Site::Centre, Real(0.7));
    const Field out = advected(q, random_velocity(), 0.4);
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) ASSERT_NEAR(out(i, j), 0.7, rounding) << i << ", " << j;
    }
}

TEST_P(AdvectorContract, NoTimeIsTheIdentity) {
    const SchemeSet& s = GetParam().schemes;
    // The scheme itself moves things at rest: ASLAM by its cross difference, the B-spline by approximating.
    const bool moves_at_rest = (s.affine() && s.zeta > 0 && s.expansion() != Expansion::CrossTerm) ||
                               s.interpolation->traits.approximates;
    if (moves_at_rest) return;  // by its formula
    const Field q = random_field();
    const Field out = advected(q, random_velocity(), 0);
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) ASSERT_NEAR(out(i, j), q(i, j), rounding) << i << ", " << j;
    }
}

TEST_P(AdvectorContract, StaysInTheRangeThatItsLimiterPromises) {
    const SchemeSet& s = GetParam().schemes;
    const bool interpolation_bounds = !s.interpolation->traits.overshoots || s.clamped;
    const bool clamps = s.limiter == Id<Limiter>("clamp") && s.advector != Id<Advector>("semi-lagrangian");
    // Reverting helps as far as the result that it reverts to is bounded.
    const bool reverts = s.limiter == Id<Limiter>("revert") && interpolation_bounds &&
                         s.advector != Id<Advector>("semi-lagrangian") &&
                         !(s.predictor_corrector() && s.affine());
    const bool bounded = clamps || reverts ||
                         (s.advector == Id<Advector>("semi-lagrangian") && interpolation_bounds) ||
                         s.advector == Id<Advector>("aslam-0");
    if (!bounded) return;  // nothing is promised
    const Field q = random_field();
    const Field out = advected(q, random_velocity(), 0.4);
    Real low = 1, high = 0;
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            low = std::min(low, q(i, j));
            high = std::max(high, q(i, j));
        }
    }
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            ASSERT_GE(out(i, j), low - rounding) << i << ", " << j;
            ASSERT_LE(out(i, j), high + rounding) << i << ", " << j;
        }
    }
}

TEST_P(AdvectorContract, AnyTimeStepIsStable) {
    const SchemeSet& s = GetParam().schemes;
    const bool unlimited = s.limiter == Id<Limiter>("none") && s.advector != Id<Advector>("semi-lagrangian");
    if (unlimited) return;  // nothing is promised
    const Field out = advected(random_field(), random_velocity(), 1000);
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) ASSERT_TRUE(std::isfinite(out(i, j)));
    }
}

const auto by_name = [](const auto& run) { return run.param.name; };
INSTANTIATE_TEST_SUITE_P(Schemes, AdvectorContract, testing::ValuesIn(combinations()), by_name);
INSTANTIATE_TEST_SUITE_P(Stencils, AdvectorContract, testing::ValuesIn(stencil_combinations()), by_name);

/// Periodic, in a uniform flow, linear semi-Lagrangian is a convolution whose weights sum to 1.
TEST(LinearSemiLagrangian, KeepsPeriodicMassInUniformFlow) {
    Pool pool(1);
    const Boundary boundary(Grid{17, 12, 0.25}, sides::periodic);
    Field q = boundary.field(Site::Centre);
    std::mt19937 random(3);
    double before = 0;
    for (int j = 0; j < q.height(); ++j) {
        for (int i = 0; i < q.width(); ++i) {
            q(i, j) = static_cast<Real>(std::uniform_real_distribution<double>(0, 1)(random));
            before += static_cast<double>(q(i, j));
        }
    }
    boundary.fill(q);
    FaceVelocity velocity = boundary.velocity();
    velocity.u.set_all(Real(1.3));
    velocity.v.set_all(Real(-0.7));
    Advection advection;
    advection.set({});
    constexpr int steps = 50;
    for (int step = 0; step < steps; ++step) {
        Field out = boundary.field(Site::Centre);
        advection.advect(q, out, {&velocity, &boundary, &pool, 0.1});
        q = out;
    }
    double after = 0;
    for (int j = 0; j < q.height(); ++j) {
        for (int i = 0; i < q.width(); ++i) after += static_cast<double>(q(i, j));
    }
    EXPECT_NEAR(after / before, 1, steps * static_cast<double>(epsilon));
}

}  // namespace
}  // namespace whorl
