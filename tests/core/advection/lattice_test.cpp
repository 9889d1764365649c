// The shared lattice against the plain form, in which each node traces its own particles.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/core/advection/scheme_step.h"
#include "tests/support/channel.h"

namespace whorl {
namespace {

/// A lattice point is named from the cell it starts in and not from the node, so places differ by rounding,
/// and gradients carry that into the sum.
constexpr double tolerance = 256 * static_cast<double>(std::numeric_limits<Real>::epsilon());

SchemeSet affine(Id<Advector> advector, Id<StencilShape> stencil, int zeta) {
    SchemeSet s;
    s.advector = advector;
    s.stencil = stencil;
    s.zeta = zeta;
    // A clamp may turn a rounding error at the border of two cells into a step; it is compared where none is.
    s.limiter = Id<Limiter>("none");
    return s;
}

const Id<Advector> advectors[] = {Id<Advector>("aslam"), Id<Advector>("aslam-0"),
                                  Id<Advector>("aslam-bilinear")};
const Id<StencilShape> stencils[] = {Id<StencilShape>("chessboard"), Id<StencilShape>("manhattan"),
                                     Id<StencilShape>("subsampling")};

std::string named(const SchemeSet& s) {
    return std::string(s.advector.key()) + " " + std::string(s.stencil.key()) + " " + std::to_string(s.zeta);
}

/// Bilinear values meet at cell borders but gradients do not: a point that rounding moves across a border
/// takes another gradient. Such nodes are few; all others agree.
void expect_equal_nearly_everywhere(const SchemeSet& schemes, const Domain& domain, double cfl) {
    const Stirred from(domain, cfl);
    const Moved lattice = move(schemes, from, {.threads = 2});
    const Moved plain = move(schemes, from, {.lattice = false});
    int nodes = 0, differing = 0;
    for (std::size_t f = 0; f < plain.size(); ++f) {
        for (int j = 0; j < plain[f].height(); ++j) {
            for (int i = 0; i < plain[f].width(); ++i) {
                const double a = static_cast<double>(lattice[f](i, j));
                const double b = static_cast<double>(plain[f](i, j));
                ++nodes;
                if (!(std::abs(a - b) <= tolerance * 6)) ++differing;
            }
        }
    }
    EXPECT_LE(differing, nodes / 200) << named(schemes) << " on " << domain.grid.nx << " × " << domain.grid.ny
                                      << " " << test::name(domain.sides);
}

TEST(Lattice, EqualsThePlainForm) {
    for (const auto advector : advectors) {
        for (const auto stencil : stencils) {
            for (int zeta = 1; zeta <= SchemeSet::max_zeta; ++zeta) {
                for (const Sides& sides : test::all_sides) {
                    expect_equal_nearly_everywhere(affine(advector, stencil, zeta), {{37, 29, 0.5}, sides},
                                                   1.7);
                }
                expect_equal_nearly_everywhere(affine(advector, stencil, zeta),
                                               {{40, 24, 1}, sides::box, true}, 0.8);
            }
        }
    }
}

TEST(Lattice, EqualsThePlainFormOverTilesAndTinyGrids) {
    for (const Grid grid :
         {Grid{300, 9, 1}, Grid{127, 5, 1}, Grid{128, 5, 1}, Grid{4, 4, 1}, Grid{65, 3, 1}, Grid{1, 7, 1}}) {
        for (const Sides& sides : test::all_sides) {
            expect_equal_nearly_everywhere(affine(advectors[0], stencils[0], 2), {grid, sides}, 2.3);
        }
    }
}

RC_GTEST_PROP(Lattice, EqualsThePlainFormOnAnyGrid, ()) {
    const SchemeSet schemes = affine(advectors[*rc::gen::inRange(0, 3)], stencils[*rc::gen::inRange(0, 3)],
                                     *rc::gen::inRange(1, SchemeSet::max_zeta + 1));
    const Domain domain{{*rc::gen::inRange(1, 160), *rc::gen::inRange(2, 40), 1},
                        test::all_sides[*rc::gen::inRange<std::size_t>(0, std::size(test::all_sides))],
                        *rc::gen::arbitrary<bool>()};
    expect_equal_nearly_everywhere(schemes, domain, *rc::gen::inRange(0, 6) * 0.7);
}

/// Clamps, and the predictor-correctors that use the lattice as their step.
TEST(Lattice, ServesEveryAdvector) {
    for (const auto base :
         {Id<BaseScheme>("aslam"), Id<BaseScheme>("aslam-clamped"), Id<BaseScheme>("aslam-bilinear")}) {
        for (const auto advector : {Id<Advector>("maccormack"), Id<Advector>("bfecc")}) {
            SchemeSet schemes = affine(advector, stencils[0], 2);
            schemes.base = base;
            expect_equal_nearly_everywhere(schemes, {{41, 33, 1}, sides::box}, 1.1);
        }
    }
    SchemeSet clamped = affine(advectors[0], stencils[0], 2);
    clamped.limiter = Id<Limiter>("clamp");
    expect_equal_nearly_everywhere(clamped, {{41, 33, 1}, sides::periodic}, 1.1);
}

/// Sums of differences from the node's own value: a constant stays what it is, to the last bit.
TEST(Lattice, KeepsAConstant) {
    for (const auto advector : advectors) {
        Stirred from({{33, 31, 1}, sides::box}, 1.4);
        from.density.set_all(Real(0.7));
        const Moved moved = move(affine(advector, stencils[0], 3), from, {});
        for (int j = 0; j < moved[0].height(); ++j) {
            for (int i = 0; i < moved[0].width(); ++i) ASSERT_EQ(moved[0](i, j), Real(0.7));
        }
    }
}

TEST(Lattice, IsTheCoarsestThatFits) {
    const auto per_cell = [](Id<StencilShape> kind, int zeta, int dimensions) {
        const Stencil stencil(kind, zeta, Id<WeightKernel>{}, dimensions, 1);
        const auto lattice = Lattice::of(stencil.particles());
        return lattice ? lattice->per_cell() : 0;
    };
    EXPECT_EQ(per_cell(stencils[0], 1, 2), 2);
    EXPECT_EQ(per_cell(stencils[0], 4, 2), 8);
    EXPECT_EQ(per_cell(stencils[1], 2, 2), 4);
    EXPECT_EQ(per_cell(stencils[2], 3, 2), 4);
    EXPECT_EQ(per_cell(Id<StencilShape>("jittered"), 2, 2), 0);
    EXPECT_EQ(per_cell(stencils[0], 0, 2), 0);
    EXPECT_EQ(per_cell(stencils[0], 2, 1), 0);
}

}  // namespace
}  // namespace whorl
