// Stacked contributions keep their sums.
#include "app/plot/stacking.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/plot/stack_plot.h"
#include "tests/support/headless_ui.h"

namespace whorl::app {
namespace {

/// Single precision over a hundred samples.
constexpr float tolerance = 1e-4f;

TEST(Stacking, PilesEachSignOnItsOwnSide) {
    const std::vector<float> a{2, -1}, b{-3, -2}, c{1, 4};
    const Series parts[] = {{"a", 0, a}, {"b", 0, b}, {"c", 0, c}};
    const Stacked stacked = stack({}, parts, 100);
    ASSERT_EQ(stacked.columns(), 2u);
    EXPECT_EQ(stacked.net(0), 0.0f);
    EXPECT_EQ(stacked.net(1), 1.0f);
    const auto expect = [&](std::size_t column, std::size_t part, bool above, double lo, double hi) {
        const Interval extent = stacked.extent(column, part, above);
        EXPECT_EQ(extent.lo, lo) << column << part << above;
        EXPECT_EQ(extent.hi, hi) << column << part << above;
    };
    expect(0, 0, true, 0, 2);
    expect(0, 1, true, 2, 2);
    expect(0, 2, true, 2, 3);
    expect(0, 1, false, 0, -3);
    expect(1, 0, false, 0, -1);
    expect(1, 1, false, -1, -3);
    expect(1, 2, true, 0, 4);
    const Interval range = fit_stack(stacked);
    EXPECT_LT(range.lo, -3);
    EXPECT_GT(range.hi, 4);
}

TEST(Stacking, AColumnIsTheMeanOfItsSamples) {
    std::vector<float> up(1000), down(1000);
    for (std::size_t k = 0; k < 1000; ++k) {
        up[k] = static_cast<float>(k % 7);
        down[k] = -static_cast<float>(k % 3);
    }
    const Series parts[] = {{"up", 0, up}, {"down", 0, down}};
    const Stacked stacked = stack({.title = "", .x_first = 5, .x_stride = 2}, parts, 10);
    ASSERT_EQ(stacked.columns(), 10u);
    EXPECT_EQ(stacked.x[0], 5 + 2 * 49.5);
    for (std::size_t column = 0; column < 10; ++column) {
        float sum_up = 0, sum_down = 0;
        for (std::size_t k = 100 * column; k < 100 * (column + 1); ++k) {
            sum_up += up[k];
            sum_down += down[k];
        }
        EXPECT_NEAR(stacked.value(column, 0), sum_up / 100, tolerance);
        EXPECT_NEAR(stacked.value(column, 1), sum_down / 100, tolerance);
        EXPECT_NEAR(stacked.net(column), (sum_up + sum_down) / 100, tolerance);
    }
}

TEST(Stacking, LeavesOutWhatIsNoNumber) {
    const std::vector<float> a{1, 2, NAN, 4}, b{1, INFINITY, 1, 1};
    const Series parts[] = {{"a", 0, a}, {"b", 0, b}};
    const Stacked all = stack({}, parts, 4);
    EXPECT_FALSE(all.gap(0));
    EXPECT_TRUE(all.gap(1)) << "a part of a sum says nothing";
    EXPECT_TRUE(all.gap(2));
    EXPECT_FALSE(all.gap(3));
    const Stacked two = stack({}, parts, 2);
    EXPECT_EQ(two.value(0, 0), 1.0f);
    EXPECT_EQ(two.value(1, 0), 4.0f);
    EXPECT_EQ(stack({}, {}, 10).columns(), 0u);
}

TEST(StackPlot, TakesAnyParts) {
    HeadlessUi ui(300, 900, 1.0f);
    const std::vector<float> none;
    const std::vector<float> one{3.0f};
    const std::vector<float> zeros(5, 0.0f);
    const std::vector<float> broken(50, NAN);
    const std::vector<float> huge{-3e38f, 3e38f};
    ImGui::GetIO().MousePos = {150.0f, 80.0f};
    for (int k = 0; k < 2; ++k) {
        for (const auto* y : {&none, &one, &zeros, &broken, &huge}) {
            const Series parts[] = {{"a", ~0u, *y}, {"b", ~0u, *y}};
            ui.frame([&] {
                draw_stack(ui.theme, {.title = "two"}, parts, "net");
                draw_stack(ui.theme, {.title = "no part"}, {}, "net");
                draw_stack(ui.theme, {.title = "tiny", .size = {3, 2}}, parts, "net");
                draw_stack(ui.theme, {.title = "marked", .marker = 1.0}, parts, "net");
            });
        }
    }
    SUCCEED();
}

TEST(StackPlot, ShowsGainAboveAndLossBelow) {
    HeadlessUi ui(316, 216, 1.0f);
    const std::vector<float> gain(10, 2.0f), loss(10, -1.0f);
    const ImU32 red = IM_COL32(255, 0, 0, 255);
    const ImU32 blue = IM_COL32(0, 0, 255, 255);
    const Series parts[] = {{"gain", red, gain}, {"loss", blue, loss}};
    std::optional<double> x;
    ImGui::GetIO().MousePos = {200.0f, 100.0f};
    for (int k = 0; k < 2; ++k) {
        ui.frame([&] { x = draw_stack(ui.theme, {.title = "budget", .size = {300, 200}}, parts, "net"); });
    }
    ASSERT_TRUE(x.has_value());
    EXPECT_EQ(*x, std::round(*x)) << "a sample's x";
    ImGui::GetIO().MousePos = {-1.0f, -1.0f};
    for (int k = 0; k < 2; ++k) {
        ui.frame([&] { draw_stack(ui.theme, {.title = "budget", .size = {300, 200}}, parts, "net"); });
    }
    const Image image = ui.picture();
    int reds = 0, blues = 0, first_blue = 0, last_red = 0;
    for (int y = 50; y < 216; ++y) {
        const std::uint8_t* p = image.rgba.data() + 4 * (std::size_t{316} * y + 160);
        const bool is_red = p[0] > 150 && p[2] < 60;
        const bool is_blue = p[2] > 150 && p[0] < 60;
        reds += is_red ? 1 : 0;
        blues += is_blue ? 1 : 0;
        if (is_red) last_red = y;
        if (is_blue && first_blue == 0) first_blue = y;
    }
    EXPECT_LT(last_red, first_blue);
    // Twice as high, but for the line of the net in the middle of the gain and the zero line.
    EXPECT_NEAR(static_cast<float>(reds + 5) / static_cast<float>(blues), 2.0f, 0.25f);
}

}  // namespace
}  // namespace whorl::app
