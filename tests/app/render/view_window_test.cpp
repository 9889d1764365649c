// Zoom and pan stay in the domain and hold what is under the pointer.
#include "app/render/view_window.h"

#include <gtest/gtest.h>

namespace whorl::app {
namespace {

/// Some roundings in single precision, in fractions of the domain.
constexpr float tolerance = 1e-5f;
constexpr glm::ivec2 cells{128, 128};

glm::vec2 place_at(const ViewWindow& window, glm::vec2 about) {
    return window.low + about * (window.high - window.low);
}

void expect_near(glm::vec2 a, glm::vec2 b) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}

void expect_inside(const ViewWindow& window) {
    for (int axis = 0; axis < 2; ++axis) {
        EXPECT_GE(window.low[axis], 0.0f);
        EXPECT_LE(window.high[axis], 1.0f);
        EXPECT_LT(window.low[axis], window.high[axis]);
    }
}

TEST(ViewWindow, ZoomHoldsWhatIsUnderThePointer) {
    const glm::vec2 about(0.3f, 0.8f);
    ViewWindow window;
    for (const float factor : {1.5f, 2.0f, 1.1f, 0.7f}) {
        const glm::vec2 before = place_at(window, about);
        window = zoomed(window, about, factor, cells);
        expect_near(place_at(window, about), before);
        expect_inside(window);
    }
    EXPECT_NEAR(window.high.x - window.low.x, 1.0f / (1.5f * 2.0f * 1.1f * 0.7f), tolerance);
}

TEST(ViewWindow, ZoomEndsAtTheClosestView) {
    const ViewWindow close = zoomed({}, {0.5f, 0.5f}, 1e9f, cells);
    EXPECT_NEAR((close.high.x - close.low.x) * 128, closest_cells, 1e-3f);
    const ViewWindow wide = zoomed({}, {1.0f, 0.0f}, 1e9f, {400, 100});
    EXPECT_NEAR((wide.high.y - wide.low.y) * 100, closest_cells, 1e-3f) << "across the shorter side";
    EXPECT_NEAR(wide.high.x - wide.low.x, wide.high.y - wide.low.y, tolerance) << "cells stay square";
    EXPECT_EQ(wide.high.x, 1.0f);
    EXPECT_EQ(wide.low.y, 0.0f);
    EXPECT_TRUE(zoomed({}, {0.5f, 0.5f}, 4.0f, {3, 3}).whole()) << "fewer cells than that are always shown";
    EXPECT_TRUE(zoomed({}, {0.5f, 0.5f}, 4.0f, {256, 1}).whole());
}

TEST(ViewWindow, ZoomingAwayGivesTheWholeDomainBack) {
    ViewWindow window = zoomed({}, {0.9f, 0.1f}, 7.3f, cells);
    EXPECT_FALSE(window.whole());
    window = zoomed(window, {0.2f, 0.7f}, 0.1f, cells);
    EXPECT_TRUE(window.whole());
}

TEST(ViewWindow, PanMovesByPartsOfTheWindowUpToTheEdge) {
    const ViewWindow window{{0.25f, 0.5f}, {0.5f, 0.75f}};
    const ViewWindow right = panned(window, {0.5f, -1.0f});
    expect_near(right.low, {0.375f, 0.25f});
    expect_near(right.high, {0.625f, 0.5f});
    const ViewWindow corner = panned(window, {100.0f, -100.0f});
    EXPECT_EQ(corner.high.x, 1.0f);
    EXPECT_EQ(corner.low.y, 0.0f);
    expect_near(corner.high - corner.low, window.high - window.low);
    EXPECT_TRUE(panned({}, {0.3f, 0.3f}).whole());
}

}  // namespace
}  // namespace whorl::app
