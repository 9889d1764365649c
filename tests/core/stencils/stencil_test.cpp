// Where the particles of a node are, and how much they count.
#include "core/stencils/stencil.h"

#include <gtest/gtest.h>

#include <cmath>

namespace whorl {
namespace {

/// [T table 4.1]; Delannoy numbers for the diamond.
TEST(Stencil, HasTheThesisNumberOfParticles) {
    const auto count = [](Id<StencilShape> kind, int zeta, int dimensions) {
        return Stencil(kind, zeta, {}, dimensions, 1).particles().size();
    };
    for (std::size_t zeta = 0; zeta <= 4; ++zeta) {
        const int z = static_cast<int>(zeta);
        EXPECT_EQ(count(Id<StencilShape>("chessboard"), z, 1), 2 * zeta + 1);
        EXPECT_EQ(count(Id<StencilShape>("chessboard"), z, 2), (2 * zeta + 1) * (2 * zeta + 1));
        EXPECT_EQ(count(Id<StencilShape>("manhattan"), z, 2), 2 * zeta * zeta + 2 * zeta + 1);
        EXPECT_EQ(count(Id<StencilShape>("subsampling"), z, 2), (zeta + 1) * (zeta + 1));
        EXPECT_EQ(count(Id<StencilShape>("jittered"), z, 2), (2 * zeta + 1) * (2 * zeta + 1));
    }
}

TEST(Stencil, StaysInItsCellAndSumsToOne) {
    for (std::size_t k = 0; k < StencilShape::list().all().size(); ++k) {
        for (std::size_t w = 0; w < WeightKernel::list().all().size(); ++w) {
            for (int zeta = 0; zeta <= 4; ++zeta) {
                for (const int dimensions : {1, 2}) {
                    double sum = 0;
                    const Stencil stencil(Id<StencilShape>::at(k), zeta, Id<WeightKernel>::at(w), dimensions,
                                          1);
                    for (const Particle& p : stencil.particles()) {
                        EXPECT_LE(std::abs(p.offset.x), Real(0.5));
                        EXPECT_LE(std::abs(p.offset.y), dimensions == 1 ? Real(0) : Real(0.5));
                        EXPECT_GT(p.weight, 0);
                        sum += static_cast<double>(p.weight);
                    }
                    EXPECT_NEAR(sum, 1, 1e-6);
                }
            }
        }
    }
}

/// [T 4.5–4.9] at a corner and in the middle, ζ = 1, two dimensions: Δ_r = √½ cells.
TEST(Stencil, WeighsByTheThesisFormulas) {
    const auto ratio = [](Id<WeightKernel> weights) {
        const Stencil stencil(Id<StencilShape>("chessboard"), 1, weights, 2, 1);
        const auto p = stencil.particles();
        return static_cast<double>(p[0].weight / p[4].weight);  // corner over centre
    };
    EXPECT_NEAR(ratio(Id<WeightKernel>("uniform")), 1, 1e-6);
    EXPECT_NEAR(ratio(Id<WeightKernel>("sph")), std::pow(1 - 1 / 2.25, 3), 1e-6);
    EXPECT_NEAR(ratio(Id<WeightKernel>("gaussian")), std::exp(-1 / (2 * 0.5625)), 1e-6);
}

TEST(Stencil, JitterFollowsItsSeed) {
    const auto offsets = [](std::uint64_t seed) {
        std::vector<Vec2> all;
        const Stencil stencil(Id<StencilShape>("jittered"), 2, {}, 2, seed);
        for (const Particle& p : stencil.particles()) all.push_back(p.offset);
        return all;
    };
    EXPECT_EQ(offsets(5), offsets(5));
    EXPECT_NE(offsets(5), offsets(6));
}

/// Blue noise: no two particles as near as random ones would come.
TEST(Stencil, JitterKeepsParticlesApart) {
    const Stencil stencil(Id<StencilShape>("jittered"), 2, {}, 2, 1);
    const auto p = stencil.particles();
    Real nearest = 1;
    for (std::size_t a = 0; a < p.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            nearest =
                std::min(nearest, std::hypot(p[a].offset.x - p[b].offset.x, p[a].offset.y - p[b].offset.y));
        }
    }
    EXPECT_GT(nearest, Real(0.08));  // 25 points in a unit cell: a lattice has 0.2
}

}  // namespace
}  // namespace whorl
