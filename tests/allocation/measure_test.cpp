// Measuring allocates nothing once it has seen a shape.
#include <gtest/gtest.h>

#include "core/measure/average.h"
#include "core/measure/spectrum.h"
#include "tests/support/allocations.h"

namespace whorl {
namespace {

TEST(Averager, AllocatesNothingOnceSettled) {
    const Boundary from({30, 24, 0.1}, sides::box);
    const Field q = from.field(Site::Centre);
    for (const Grid& to : {Grid{10, 8, 0.3}, Grid{25, 20, 0.12}, Grid{60, 48, 0.05}}) {
        Field out(to.nx, to.ny, Site::Centre);
        Averager averager;
        averager.average(q, from, to, out);
        const long before = test::allocations();
        averager.average(q, from, to, out);
        EXPECT_EQ(test::allocations(), before) << to.nx;
    }
}

TEST(Spectrum, AllocatesNothingOnceSettled) {
    for (const Sides sides : {sides::box, sides::periodic}) {
        const Boundary boundary({30, 21, 0.1}, sides);
        const FaceVelocity velocity = boundary.velocity();
        Spectrum spectrum;
        spectrum.compute(velocity, boundary);
        const long before = test::allocations();
        spectrum.compute(velocity, boundary);
        EXPECT_EQ(test::allocations(), before) << boundary.wraps().x;
    }
}

}  // namespace
}  // namespace whorl
