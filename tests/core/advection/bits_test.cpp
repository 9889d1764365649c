// Results are the same bits on every instruction set and with any number of threads.
#include <gtest/gtest.h>

#include "tests/core/advection/scheme_step.h"
#include "tests/support/channel.h"

namespace whorl {
namespace {

const Domain domains[] = {{{67, 21, 0.5}, sides::box},          {{67, 21, 0.5}, sides::periodic},
                          {{40, 33, 1}, sides::box, true},      {{90, 1, 1}, sides::periodic},
                          {{40, 33, 1}, test::channel_x, true}, {{40, 33, 1}, test::channel_y, true}};

/// A CFL number at which some lanes read in a row and others do not.
constexpr double cfl = 3.3;

template <class Entry, class F>
void for_each(F&& f) {
    for (const Entry* entry : Entry::list().all()) f(Id<Entry>(*entry));
}

void expect_same_on_every_isa(const SchemeSet& schemes) {
    for (const Domain& domain : domains) {
        const Stirred from(domain, cfl);
        const Moved baseline = move(schemes, from, {.isa = Isa::Baseline});
        for (const Isa isa : available_isas()) {
            ASSERT_EQ(difference(move(schemes, from, {.isa = isa}), baseline), 0)
                << name(isa) << " " << schemes.advector.key() << " " << schemes.interpolation.key() << " "
                << schemes.tracer.key() << " " << schemes.limiter.key();
        }
    }
}

TEST(InstructionSets, AgreeOnEveryInterpolation) {
    for_each<Interpolation>([](Id<Interpolation> interpolation) {
        for_each<AxisOrder>([&](Id<AxisOrder> order) {
            for (const bool clamped : {false, true}) {
                SchemeSet schemes;
                schemes.interpolation = interpolation;
                schemes.axis_order = order;
                schemes.clamped = clamped;
                expect_same_on_every_isa(schemes);
            }
        });
    });
}

TEST(InstructionSets, AgreeOnEveryTracerAndLimiter) {
    for_each<Tracer>([](Id<Tracer> tracer) {
        for_each<Limiter>([&](Id<Limiter> limiter) {
            SchemeSet schemes;
            schemes.advector = Id<Advector>("maccormack");
            schemes.interpolation = Id<Interpolation>("catmull-rom");
            schemes.tracer = tracer;
            schemes.limiter = limiter;
            expect_same_on_every_isa(schemes);
        });
    });
}

TEST(InstructionSets, AgreeOnEveryAdvectorAndStencil) {
    for_each<Advector>([](Id<Advector> advector) {
        for_each<StencilShape>([&](Id<StencilShape> stencil) {
            SchemeSet schemes;
            schemes.advector = advector;
            schemes.base = Id<BaseScheme>("aslam-clamped");
            schemes.stencil = stencil;
            expect_same_on_every_isa(schemes);
        });
    });
}

TEST(AdvectionThreads, DoNotChangeABit) {
    for_each<Advector>([](Id<Advector> advector) {
        for_each<BaseScheme>([&](Id<BaseScheme> base) {
            SchemeSet schemes;
            schemes.advector = advector;
            schemes.base = base;
            for (const Domain& domain : domains) {
                const Stirred from(domain, cfl);
                const Moved one = move(schemes, from, {.threads = 1});
                for (const int threads : {2, 3}) {
                    ASSERT_EQ(difference(move(schemes, from, {.threads = threads}, 2), one), 0)
                        << advector.key() << " over " << base.key() << ", " << threads << " threads";
                }
            }
        });
    });
}

}  // namespace
}  // namespace whorl
