// Advection allocates in its first step, and in none after it.
#include <gtest/gtest.h>

#include "tests/core/advection/scheme_step.h"
#include "tests/support/allocations.h"

namespace whorl {
namespace {

TEST(Advection, AllocatesOnlyInItsFirstStep) {
    const Stirred from({{70, 50, 1}, Sides::of<Box>(), true}, 1.5);
    Field density = from.density, temperature = from.temperature;
    FaceVelocity velocity = from.velocity;
    const AdvectedField fields[] = {{&from.density, &density},
                                    {&from.temperature, &temperature},
                                    {&from.velocity.u, &velocity.u},
                                    {&from.velocity.v, &velocity.v}};
    Pool pool(2);
    for (std::size_t a = 0; a < Advectors::infos.size(); ++a) {
        for (std::size_t b = 0; b < Bases::infos.size(); ++b) {
            for (std::size_t s = 0; s < Stencils::infos.size(); ++s) {
                SchemeSet schemes;
                schemes.advector = Advectors::Id::at(a);
                schemes.base = Bases::Id::at(b);
                schemes.stencil = Stencils::Id::at(s);
                schemes.zeta = 1;
                Mover mover;
                const auto step = [&] {
                    mover.set(schemes, 2, 1);
                    mover.advect(fields, from.velocity, 1, from.boundary, pool);
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
