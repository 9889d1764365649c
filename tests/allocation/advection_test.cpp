// Advection allocates in its first step, and in none after it.
#include <gtest/gtest.h>

#include "tests/core/advection/scheme_step.h"
#include "tests/support/allocations.h"

namespace whorl {
namespace {

TEST(Advection, AllocatesOnlyInItsFirstStep) {
    const Stirred from({{70, 50, 1}, sides::box, true}, 1.5);
    Field density = from.density, temperature = from.temperature;
    FaceVelocity velocity = from.velocity;
    const AdvectedField fields[] = {{&from.density, &density},
                                    {&from.temperature, &temperature},
                                    {&from.velocity.u, &velocity.u},
                                    {&from.velocity.v, &velocity.v}};
    Pool pool(2);
    for (std::size_t a = 0; a < Advector::list().all().size(); ++a) {
        for (std::size_t b = 0; b < BaseScheme::list().all().size(); ++b) {
            for (std::size_t s = 0; s < StencilShape::list().all().size(); ++s) {
                SchemeSet schemes;
                schemes.advector = Id<Advector>::at(a);
                schemes.base = Id<BaseScheme>::at(b);
                schemes.stencil = Id<StencilShape>::at(s);
                schemes.zeta = 1;
                Advection advection;
                const auto step = [&] {
                    advection.set({schemes});
                    advection.advect(fields, {&from.velocity, &from.boundary, &pool, 1});
                };
                step();
                const long before = test::allocations();
                for (int k = 0; k < 3; ++k) step();
                EXPECT_EQ(test::allocations(), before) << schemes.advector.key() << " over "
                                                       << schemes.base.key() << ", " << schemes.stencil.key();
            }
        }
    }
}

}  // namespace
}  // namespace whorl
