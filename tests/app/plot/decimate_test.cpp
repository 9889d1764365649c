// Decimation keeps what a curve shows.
#include "app/plot/decimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace whorl::app {
namespace {

TEST(Decimate, KeepsExtremaInOrder) {
    std::vector<float> y(10'000);
    for (std::size_t k = 0; k < y.size(); ++k) y[k] = std::sin(0.01f * static_cast<float>(k));
    y[4321] = 7.0f;
    y[4322] = -9.0f;
    std::vector<CurvePoint> points;
    decimate(y, 300, false, points);
    EXPECT_LE(points.size(), 600u);
    const auto holds = [&](std::size_t index, float value) {
        return std::any_of(points.begin(), points.end(),
                           [&](const CurvePoint& p) { return p.index == index && p.y == value; });
    };
    EXPECT_TRUE(holds(4321, 7.0f));
    EXPECT_TRUE(holds(4322, -9.0f));
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end(),
                               [](const CurvePoint& a, const CurvePoint& b) { return a.index < b.index; }));
    for (const CurvePoint& point : points) EXPECT_EQ(point.y, y[point.index]);
}

TEST(Decimate, LeavesShortCurvesAlone) {
    const std::vector<float> y{3, 1, 2, 2};
    std::vector<CurvePoint> points;
    decimate(y, 100, false, points);
    ASSERT_EQ(points.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(points[k].index, k);
        EXPECT_EQ(points[k].y, y[k]);
    }
    decimate({}, 100, false, points);
    EXPECT_TRUE(points.empty());
}

TEST(Decimate, MarksGaps) {
    const std::vector<float> y{1, NAN, 2, INFINITY, 0, -1};
    std::vector<CurvePoint> points;
    decimate(y, 100, false, points);
    ASSERT_EQ(points.size(), 6u);
    EXPECT_TRUE(std::isnan(points[1].y));
    EXPECT_TRUE(std::isnan(points[3].y));
    EXPECT_EQ(points[5].y, -1.0f);
    decimate(y, 100, true, points);
    EXPECT_TRUE(std::isnan(points[4].y)) << "0 has no place on a logarithmic axis";
    EXPECT_TRUE(std::isnan(points[5].y));
}

TEST(Decimate, ShowsAGapOfOneSampleAmongThousands) {
    std::vector<float> y(5'000, 1.0f);
    y[2500] = NAN;
    std::vector<CurvePoint> points;
    decimate(y, 100, false, points);
    EXPECT_EQ(
        std::count_if(points.begin(), points.end(), [](const CurvePoint& p) { return std::isnan(p.y); }), 1);
}

}  // namespace
}  // namespace whorl::app
