// How close the view goes to what is drawn around a node.
#include <gtest/gtest.h>

#include "app/inspector/inspection.h"
#include "app/inspector/overlay.h"

namespace whorl::app {
namespace {

TEST(Inspector, WindowsAroundNodesStayInTheDomain) {
    Explanation e;
    e.steps.resize(1);
    for (const WorldPoint corner :
         {WorldPoint{0, 0}, WorldPoint{40, 0}, WorldPoint{40, 20}, WorldPoint{3, 19}}) {
        e.at = corner;
        e.steps[0].path.start = corner;
        e.steps[0].path.end = {20, 10};
        const ViewWindow window = window_around(e, {}, {40, 20}, 0.5);
        EXPECT_GE(window.low.x, 0);
        EXPECT_GE(window.low.y, 0);
        EXPECT_LE(window.high.x, 1);
        EXPECT_LE(window.high.y, 1);
        EXPECT_FLOAT_EQ(window.high.x - window.low.x, window.high.y - window.low.y);
    }
    // Ways that leave a periodic domain: all of it.
    e.steps[0].path.end = {-100, 300};
    EXPECT_TRUE(window_around(e, {}, {40, 20}, 0.5).whole());
}

TEST(Inspector, WindowsAroundNodesAreHalfFilled) {
    Explanation e, wide;
    e.at = {20.25, 10.25};
    e.steps.resize(1);
    e.steps[0].path.start = e.at;
    e.steps[0].path.end = {23.5, 10.25};
    wide = e;
    const auto cells = [](const ViewWindow& window) {
        return static_cast<double>(window.high.y - window.low.y) * 20 / 0.5;
    };
    // From the cell's left edge to the path's end, 7 cells, in a window of 28 × 14: half of the longer side
    // would be less than what the closest view shows.
    EXPECT_NEAR(cells(window_around(e, {}, {40, 20}, 0.5)), 7, 1e-4);
    e.steps[0].path.end = {20.25, 13.5};
    EXPECT_NEAR(cells(window_around(e, {}, {40, 20}, 0.5)), 14, 1e-4) << "of the shorter side";
    e.steps[0].path.end = e.at;
    EXPECT_NEAR(cells(window_around(e, {}, {40, 20}, 0.5)), static_cast<double>(closest_cells), 1e-4);
    // Another lane's 7 cells and a margin of half a cell all fit beside it.
    const Explanation* const others[] = {&wide};
    const ViewWindow all = window_around(e, others, {40, 20}, 0.5);
    EXPECT_NEAR(cells(all), 4, 1e-4);
    EXPECT_NEAR(all.low.x, 19.75 / 40, 1e-6);
    EXPECT_NEAR(all.high.x, 23.75 / 40, 1e-6);
}

}  // namespace
}  // namespace whorl::app
