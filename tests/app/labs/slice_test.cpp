// The slice: what a line is in a grid, the curves along it, and how its ends move.
#include "app/labs/slice.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

constexpr double epsilon = std::numeric_limits<Real>::epsilon();
constexpr double rounding = 1e-12;  // of fractions and cells in double precision

// ---- curves

/// A lane of 12 × 9 cells without smoke.
Snapshot clear_lane(bool periodic) {
    Snapshot lane;
    lane.state.boundary = Boundary(Grid{12, 9, 0.5}, periodic ? sides::periodic : sides::box);
    lane.state.scalars.push_back(lane.state.boundary.field(Site::Centre));
    return lane;
}

/// A lane with a solid and smoke that differs from cell to cell.
Snapshot some_lane(bool periodic) {
    Snapshot lane = clear_lane(periodic);
    std::vector<std::uint8_t> mask(12 * 9, 0);
    mask[4 * 12 + 7] = 1;
    lane.state.boundary.set_solids(mask);
    for (int j = 0; j < 9; ++j) {
        for (int i = 0; i < 12; ++i)
            lane.state.density()(i, j) = static_cast<Real>(std::sin(1.7 * i + 2.9 * j));
    }
    return lane;
}

/// A line between two points in samples of a grid of 12 × 9.
SliceLine between(glm::dvec2 from, glm::dvec2 to) {
    const glm::dvec2 cells(12, 9);
    return {(from + 0.5) / cells, (to + 0.5) / cells};
}

/// Thousandths.
double any_fraction(int low, int high) {
    return *rc::gen::inRange(low, high + 1) / 1000.0;
}

/// A line in any direction, its ends a tenth of the domain apart at least.
SliceLine any_line() {
    SliceLine line{{any_fraction(0, 400), any_fraction(0, 1000)},
                   {any_fraction(500, 1000), any_fraction(0, 1000)}};
    if (*rc::gen::arbitrary<bool>()) std::swap(line.from, line.to);
    if (*rc::gen::arbitrary<bool>()) line = {{line.from.y, line.from.x}, {line.to.y, line.to.x}};
    return line;
}

SchemeSet by_interpolation(std::size_t k) {
    SchemeSet schemes;
    schemes.interpolation = Id<Interpolation>::at(k);
    return schemes;
}

TEST(Slice, ARowsDotsAreItsCellsAndCurvesPassThroughThem) {
    for (const bool periodic : {false, true}) {
        const Snapshot lane = some_lane(periodic);
        FilledFields fields;
        const Field& filled = fields.of(0, lane, lane.density(), 1);
        for (const bool vertical : {false, true}) {
            const int across = vertical ? 7 : 4;
            const SliceLine line = vertical ? SliceLine::column(7.3 / 12) : SliceLine::row(4.9 / 9);
            const SliceCurve cells = cells_along(lane.density(), lane, line);
            ASSERT_EQ(cells.y.size(), vertical ? 9u : 12u);
            for (std::size_t scheme = 0; scheme < Interpolation::list().all().size(); ++scheme) {
                const SchemeSet schemes = by_interpolation(scheme);
                const SliceCurve curve = curve_along(filled, lane, line, schemes, 8);
                EXPECT_EQ(curve.x.front(), 0);
                EXPECT_EQ(curve.x.back(), vertical ? 4.5f : 6.0f) << "from side to side";
                for (std::size_t k = 0; k < cells.y.size(); ++k) {
                    const int at = static_cast<int>(k);
                    EXPECT_EQ(cells.x[k], 0.5f * (static_cast<float>(at) + 0.5f));
                    const auto same = std::find(curve.x.begin(), curve.x.end(), cells.x[k]);
                    ASSERT_NE(same, curve.x.end());
                    const float value = curve.y[static_cast<std::size_t>(same - curve.x.begin())];
                    const bool solid = k == (vertical ? 4u : 7u);
                    EXPECT_EQ(std::isnan(cells.y[k]), solid);
                    EXPECT_EQ(std::isnan(value), solid);
                    if (solid) continue;
                    EXPECT_EQ(cells.y[k], vertical ? lane.density()(across, at) : lane.density()(at, across));
                    const bool interpolates = schemes.interpolation != Id<Interpolation>("b-spline");
                    EXPECT_EQ(value == cells.y[k], interpolates);
                }
            }
        }
    }
}

TEST(Slice, APartOfARowHasItsCellsAndNoOthers) {
    const Snapshot lane = some_lane(false);
    const SliceCurve there = cells_along(lane.density(), lane, between({2.25, 3}, {5.75, 3}));
    ASSERT_EQ(there.y.size(), 3u);
    const SliceCurve back = cells_along(lane.density(), lane, between({5.75, 3}, {2.25, 3}));
    ASSERT_EQ(back.y.size(), 3u);
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(there.y[static_cast<std::size_t>(k)], lane.density()(3 + k, 3));
        EXPECT_FLOAT_EQ(there.x[static_cast<std::size_t>(k)], 0.5f * (0.75f + static_cast<float>(k)));
        EXPECT_EQ(back.y[static_cast<std::size_t>(k)], lane.density()(5 - k, 3));
    }
}

TEST(Slice, ALineThatAllButRunsAlongARowHasTheRowsValues) {
    for (const bool periodic : {false, true}) {
        const Snapshot lane = some_lane(periodic);
        FilledFields fields;
        const Field& filled = fields.of(0, lane, lane.density(), 1);
        constexpr double tilt = 1e-4;  // cells
        const SliceLine row = between({0.5, 2}, {9, 2});
        const SliceLine tilted = between({0.5, 2 - tilt}, {9, 2 + tilt});
        EXPECT_FALSE(tilted.horizontal());
        EXPECT_TRUE(cells_along(lane.density(), lane, tilted).y.empty()) << "no centre lies on it";
        for (std::size_t scheme = 0; scheme < Interpolation::list().all().size(); ++scheme) {
            const SliceCurve along = curve_along(filled, lane, row, by_interpolation(scheme), 8);
            const SliceCurve oblique = curve_along(filled, lane, tilted, by_interpolation(scheme), 8);
            // The field is within 1 and the slopes of every interpolation within 3 differences of cells.
            constexpr double most = 6 * tilt + 16 * epsilon;
            for (std::size_t k = 0; k < along.x.size(); ++k) {
                const auto near = std::lower_bound(oblique.x.begin(), oblique.x.end(), along.x[k] - 1e-4f);
                ASSERT_NE(near, oblique.x.end());
                ASSERT_NEAR(*near, along.x[k], 1e-4);
                const float value = oblique.y[static_cast<std::size_t>(near - oblique.x.begin())];
                EXPECT_NEAR(value, along.y[k], 2 * most) << Id<Interpolation>::at(scheme).key() << ' ' << k;
            }
        }
    }
}

RC_GTEST_PROP(Slice, EveryInterpolationIsExactOnALinearField, ()) {
    Snapshot lane = clear_lane(false);
    const double a = *rc::gen::inRange(-50, 51) / 10.0;
    const double b = *rc::gen::inRange(-50, 51) / 10.0;
    for (int j = 0; j < 9; ++j) {
        for (int i = 0; i < 12; ++i) lane.state.density()(i, j) = static_cast<Real>(a * i + b * j);
    }
    FilledFields fields;
    const Field& filled = fields.of(0, lane, lane.density(), 1);
    // Two cells from the walls: nearer, ghosts level the field, and the B-spline has weights of its own.
    const auto inner = [](int low, int high) { return *rc::gen::inRange(100 * low, 100 * high) / 100.0; };
    glm::dvec2 from(inner(2, 5), inner(2, 6));
    glm::dvec2 to(inner(6, 9), inner(2, 6));
    if (*rc::gen::arbitrary<bool>()) std::swap(from, to);
    const SliceLine line = between(from, to);
    const GridLine placed = place_line(line, lane.grid());
    for (std::size_t scheme = 0; scheme < Interpolation::list().all().size(); ++scheme) {
        const SliceCurve curve = curve_along(filled, lane, line, by_interpolation(scheme), 5);
        for (std::size_t k = 0; k < curve.x.size(); ++k) {
            const glm::dvec2 at = placed.at(static_cast<double>(curve.x[k]) / placed.length());
            // Sums of sixteen samples of size 5 · 20, at places that are rounded too.
            RC_ASSERT(std::abs(static_cast<double>(curve.y[k]) - (a * at.x + b * at.y)) <=
                      16 * 100 * epsilon);
        }
    }
}

RC_GTEST_PROP(Slice, SamplesAscendFromEndToEndAndLieNoFartherApartThanAsked, ()) {
    const Snapshot lane = clear_lane(true);
    const SliceLine line = any_line();
    const GridLine placed = place_line(line, lane.grid());
    FilledFields fields;
    const SliceCurve curve = curve_along(fields.of(0, lane, lane.density(), 1), lane, line, {}, 4);
    RC_ASSERT(curve.x.front() == 0.0f);
    RC_ASSERT(std::abs(static_cast<double>(curve.x.back()) - placed.length()) <= 8 * epsilon * 8);
    for (std::size_t k = 1; k < curve.x.size(); ++k) {
        RC_ASSERT(curve.x[k] >= curve.x[k - 1]);
        RC_ASSERT(static_cast<double>(curve.x[k] - curve.x[k - 1]) <= 0.5 / 4 + 1e-5);
        RC_ASSERT(curve.y[k] == 0.0f);
    }
}

TEST(Slice, SolidsAreGapsOfAnObliqueLine) {
    const Snapshot lane = some_lane(false);
    FilledFields fields;
    const SliceLine line = between({5, 2.2}, {9, 5.8});
    const GridLine placed = place_line(line, lane.grid());
    const SliceCurve curve = curve_along(fields.of(0, lane, lane.density(), 1), lane, line, {}, 16);
    int gaps = 0;
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        const glm::dvec2 at = placed.at(static_cast<double>(curve.x[k]) / placed.length());
        const glm::dvec2 off = glm::abs(at - glm::dvec2(7, 4));
        // Beside the solid's edge, where rounding decides.
        if (std::abs(std::max(off.x, off.y) - 0.5) < 1e-5) continue;
        EXPECT_EQ(std::isnan(curve.y[k]), std::max(off.x, off.y) < 0.5) << k;
        gaps += std::isnan(curve.y[k]);
    }
    EXPECT_GT(gaps, 10);
}

TEST(Slice, InOneDimensionTheLineIsTheDomain) {
    const GridLine placed = place_line(between({3, 1}, {4, 7}), {12, 1, 0.5});
    EXPECT_EQ(placed.from, glm::dvec2(-0.5, 0));
    EXPECT_EQ(placed.to, glm::dvec2(11.5, 0));
    EXPECT_EQ(placed.length(), 6);
}

TEST(Slice, LanesOfAnyResolutionShareALine) {
    const SliceLine line{{0.25, 0.125}, {0.75, 1}};
    for (const int finer : {1, 2, 5}) {
        const GridLine placed = place_line(line, {16 * finer, 8 * finer, 1.0 / finer});
        EXPECT_NEAR(placed.world(0).x, 4, rounding);
        EXPECT_NEAR(placed.world(0).y, 1, rounding);
        EXPECT_NEAR(placed.world(1).x, 12, rounding);
        EXPECT_NEAR(placed.world(1).y, 8, rounding);
    }
}

// ---- dragging as arithmetic

constexpr glm::dvec2 near{0.01, 0.01};
constexpr Grid grid{40, 40, 1};

bool inside(glm::dvec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x <= 1 && at.y <= 1;
}

TEST(SliceLine, AnEndThatComesNearTheOthersHeightSnapsToItsRow) {
    const SliceLine line{{0.1, 0.31}, {0.9, 0.6}};
    const SliceLine flat = dragged(line, SliceGrip::To, {-0.1, -0.285}, near, grid);
    EXPECT_TRUE(flat.horizontal());
    EXPECT_NEAR(flat.to.x, 0.8, rounding);
    EXPECT_NEAR(flat.to.y, 12.5 / 40, rounding) << "the row's centre";
    EXPECT_EQ(place_line(flat, grid).from.y, 12);
    const SliceLine oblique = dragged(line, SliceGrip::To, {-0.1, -0.27}, near, grid);
    EXPECT_FALSE(oblique.horizontal());
    EXPECT_EQ(oblique.from, line.from);
    const SliceLine upright = dragged(line, SliceGrip::From, {0.795, 0.1}, near, grid);
    EXPECT_TRUE(upright.vertical());
    EXPECT_EQ(place_line(upright, grid).from.x, 36);
    EXPECT_FALSE(upright.horizontal());
}

TEST(SliceLine, AHorizontalLineMovesFromRowToRowAndNotOut) {
    const SliceLine row = SliceLine::row();
    const SliceLine up = dragged(row, SliceGrip::Whole, {0.3, 0.1}, near, grid);
    EXPECT_TRUE(up.horizontal());
    EXPECT_EQ(up.from.x, 0) << "there is no room to the side";
    EXPECT_EQ(up.to.x, 1);
    EXPECT_EQ(place_line(up, grid).from.y, 24);
    const SliceLine top = dragged(row, SliceGrip::Whole, {0, 7}, near, grid);
    EXPECT_EQ(place_line(top, grid).from.y, 39);
    EXPECT_EQ(place_line(dragged(top, SliceGrip::Whole, {0, -7}, near, grid), grid).from.y, 0);
}

TEST(SliceLine, IsACellLongAtLeast) {
    const SliceLine line{{0.5, 0.5}, {0.7, 0.5}};
    for (const double x : {-0.2, -0.19, -0.21}) {
        const SliceLine shortest = dragged(line, SliceGrip::To, {x, 0}, near, grid);
        EXPECT_NEAR(place_line(shortest, grid).cells(), 1, rounding) << x;
        EXPECT_TRUE(shortest.horizontal());
    }
    const SliceLine cornered{{1, 0.5}, {0.5, 0.5}};
    const SliceLine kept = dragged(cornered, SliceGrip::To, {3, 0}, near, grid);
    EXPECT_NEAR(kept.to.x, 1 - 1.0 / 40, rounding);
}

RC_GTEST_PROP(SliceLine, StaysInTheDomainAndACellLong, ()) {
    const SliceLine line = any_line();
    const auto grip = *rc::gen::element(SliceGrip::From, SliceGrip::To, SliceGrip::Whole);
    const glm::dvec2 by(any_fraction(-2000, 2000), any_fraction(-2000, 2000));
    const SliceLine now = dragged(line, grip, by, near, grid);
    RC_ASSERT(inside(now.from) && inside(now.to));
    RC_ASSERT(place_line(now, grid).cells() >= 1 - rounding);
    if (grip == SliceGrip::Whole && !line.horizontal() && !line.vertical())
        RC_ASSERT(glm::distance(now.to - now.from, line.to - line.from) <= rounding);
}

}  // namespace
}  // namespace whorl::app
