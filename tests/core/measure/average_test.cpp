// Bringing a field to another grid: what is kept, what is exact.
#include "core/measure/average.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "core/scene/state.h"

namespace whorl {
namespace {

/// Each value is rounded to Real once; sums of some thousand of them are in double.
constexpr double rounding = 1e-12 + std::numeric_limits<Real>::epsilon();

constexpr double side = 6;  // length of a square domain

Boundary domain(int nx, int ny = 0, Sides sides = sides::box) {
    return {{nx, ny > 0 ? ny : nx, side / nx}, sides};
}

Field random_field(const Boundary& boundary) {
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> values(-1, 1);
    Field q = boundary.field(Site::Centre);
    write_samples(q, boundary.grid(), [&](WorldPoint) { return values(engine); });
    boundary.fill(q);
    return q;
}

double linear(WorldPoint at) {
    return 0.5 + 0.25 * at.x - 0.125 * at.y;
}

Field averaged(const Field& q, const Boundary& from, const Boundary& to) {
    Field out = to.field(Site::Centre);
    Averager().average(q, from, to.grid(), out);
    return out;
}

TEST(Averager, KeepsTheIntegral) {
    const std::pair<int, int> finer[] = {{64, 32}, {64, 8}, {48, 32}, {37, 36}, {37, 5}, {101, 13}, {7, 2}};
    for (const auto& [fine, coarse] : finer) {
        const Boundary from = domain(fine);
        const Boundary to = domain(coarse);
        const Field q = random_field(from);
        const double area = side * side;
        EXPECT_NEAR(total(averaged(q, from, to), to), total(q, from), rounding * area)
            << fine << " to " << coarse;
    }
}

TEST(Averager, KeepsTheIntegralOfOneRowAndOfUnlikeRatios) {
    const Boundary row = domain(30, 1);
    const Boundary coarse_row = domain(7, 1);
    const Field q = random_field(row);
    EXPECT_NEAR(total(averaged(q, row, coarse_row), coarse_row), total(q, row), rounding * side);
    // 3 to 2 along x, 9 to 6 along y: a domain that is not square.
    const Boundary from({30, 45, side / 30}, sides::box);
    const Boundary to({20, 30, side / 20}, sides::box);
    const Field p = random_field(from);
    EXPECT_NEAR(total(averaged(p, from, to), to), total(p, from), rounding * side * side * 1.5);
}

TEST(Averager, IsTheMeanOfABoxWhereCellsFit) {
    for (const int times : {2, 4, 8}) {
        const Boundary from = domain(5 * times);
        const Boundary to = domain(5);
        const Field q = random_field(from);
        const Field out = averaged(q, from, to);
        for (int j = 0; j < 5; ++j) {
            for (int i = 0; i < 5; ++i) {
                double mean = 0;
                for (int b = 0; b < times; ++b) {
                    for (int a = 0; a < times; ++a)
                        mean += static_cast<double>(q(i * times + a, j * times + b));
                }
                EXPECT_NEAR(out(i, j), mean / (times * times), rounding);
            }
        }
    }
}

TEST(Averager, WeighsTheCellsThatTwoShare) {
    const Boundary from = domain(3, 1);
    const Boundary to = domain(2, 1);
    Field q = from.field(Site::Centre);
    q(0, 0) = 3;
    q(1, 0) = 6;
    q(2, 0) = 12;
    const Field out = averaged(q, from, to);
    EXPECT_NEAR(out(0, 0), 4, 4 * rounding);
    EXPECT_NEAR(out(1, 0), 10, 10 * rounding);
}

TEST(Averager, IsExactOfLinearFields) {
    // Averages where fine cells fit into coarse ones; samples, away from walls, where it goes the other way.
    const std::pair<int, int> pairs[] = {{40, 20}, {40, 5}, {20, 40}, {20, 33}, {12, 12}};
    for (const auto& [fine, coarse] : pairs) {
        const Boundary from = domain(fine);
        const Boundary to = domain(coarse);
        Field q = from.field(Site::Centre);
        write_samples(q, from.grid(), linear);
        from.fill(q);
        const Field out = averaged(q, from, to);
        const double margin = coarse > fine ? from.grid().h / 2 : 0;
        for (int j = 0; j < coarse; ++j) {
            for (int i = 0; i < coarse; ++i) {
                const WorldPoint at = world(out, to.grid(), i, j);
                if (std::min({at.x, at.y, side - at.x, side - at.y}) < margin) continue;
                // Values are below 2, and three interpolations round.
                EXPECT_NEAR(out(i, j), linear(at), 8 * rounding) << fine << " to " << coarse;
            }
        }
    }
}

TEST(Averager, CopiesBitsBetweenEqualGrids) {
    const Boundary boundary = domain(9, 4);
    Field q = random_field(boundary);
    q(2, 2) = -0.0F;
    q(3, 3) = std::numeric_limits<Real>::denorm_min();
    const Field out = averaged(q, boundary, boundary);
    for (int j = 0; j < 4; ++j) EXPECT_EQ(std::memcmp(q.row(j), out.row(j), 9 * sizeof(Real)), 0);
}

TEST(Averager, SamplesAcrossPeriodicSides) {
    const Boundary from = domain(4, 4, sides::periodic);
    const Boundary to = domain(8, 8, sides::periodic);
    const Field q = random_field(from);
    const Field out = averaged(q, from, to);
    const auto along = [&](int j) { return 0.25 * q(3, j) + 0.75 * q(0, j); };
    EXPECT_NEAR(out(0, 0), 0.25 * along(3) + 0.75 * along(0), 4 * rounding);
}

TEST(Averager, AnswersForOneShapeAfterAnother) {
    const Boundary fine = domain(60), middle = domain(41), coarse = domain(13);
    const Field q = random_field(fine);
    Averager averager;
    for (const Boundary* to : {&middle, &coarse, &middle, &fine}) {
        Field out = to->field(Site::Centre);
        averager.average(q, fine, to->grid(), out);
        const Field expected = averaged(q, fine, *to);
        for (int j = 0; j < out.height(); ++j)
            EXPECT_EQ(std::memcmp(out.row(j), expected.row(j), sizeof(Real) * out.width()), 0);
    }
}

}  // namespace
}  // namespace whorl
