// The plot widget in ImGui frames without a window.
#include "app/plot/plot.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <vector>

#include "tests/support/headless_ui.h"

namespace whorl::app {
namespace {

std::vector<float> wave(std::size_t n) {
    std::vector<float> y(n);
    for (std::size_t k = 0; k < n; ++k) y[k] = 2.0f + std::sin(0.02f * static_cast<float>(k));
    return y;
}

TEST(PlotWidget, TellsTheSampleUnderThePointer) {
    HeadlessUi ui(400, 200, 1.0f);
    const std::vector<float> y = wave(101);
    const Series series[] = {{"E", ui.theme.palette.series[0], y}};
    Plot plot{.title = "Energy", .x_first = 50.0, .x_stride = 2.0};
    std::optional<double> x;
    ImGui::GetIO().MousePos = {389.0f - 14.0f - 1.0f, 100.0f};  // the frame's right end
    for (int k = 0; k < 3; ++k) ui.frame([&] { x = draw_plot(ui.theme, plot, series); });
    ASSERT_TRUE(x.has_value());
    EXPECT_NEAR(*x, 250.0, 4.0);
    ImGui::GetIO().MousePos = {5.0f, 5.0f};
    for (int k = 0; k < 3; ++k) ui.frame([&] { x = draw_plot(ui.theme, plot, series); });
    EXPECT_FALSE(x.has_value());
}

TEST(PlotWidget, TakesAnyCurves) {
    HeadlessUi ui(300, 900, 1.0f);
    const std::vector<float> none;
    const std::vector<float> one{3.0f};
    const std::vector<float> constant(50, 4.0f);
    const std::vector<float> broken(50, NAN);
    const std::vector<float> huge{-3e38f, 3e38f};
    const std::vector<float> zeros(5, 0.0f);
    const std::vector<float> x{0.0f, 1.0f, 5.0f};
    ImGui::GetIO().MousePos = {150.0f, 80.0f};
    for (int k = 0; k < 2; ++k) {
        for (const auto* y : {&none, &one, &constant, &broken, &huge, &zeros}) {
            for (const bool log_y : {false, true}) {
                const Series series[] = {{"a", ~0u, *y}, {"b", ~0u, none}};
                ui.frame([&] {
                    draw_plot(ui.theme, {.title = "uniform", .log_y = log_y}, series);
                    draw_plot(ui.theme, {.title = "given x", .x = x, .log_y = log_y}, series);
                    draw_plot(ui.theme, {.title = "no curve"}, {});
                    draw_plot(ui.theme, {.title = "tiny", .size = {3, 2}}, series);
                    draw_plot(ui.theme, {.title = "marked", .marker = 1.0}, series);
                });
            }
        }
    }
    SUCCEED();
}

TEST(PlotWidget, SixPlotsOfTenThousandSamplesAreQuick) {
    HeadlessUi ui(400, 1100, 1.0f);
    const std::vector<float> y = wave(10'000);
    const Series series[] = {{"this run", ui.theme.palette.series[0], y},
                             {"reference", ui.theme.palette.series[1], y}};
    double best = 1e9;
    for (int k = 0; k < 20; ++k) {
        ui.frame([&] {
            const auto start = std::chrono::steady_clock::now();
            for (int p = 0; p < 6; ++p) {
                ImGui::PushID(p);
                draw_plot(ui.theme, {.title = "plot"}, series);
                ImGui::PopID();
            }
            const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
            best = std::min(best, took.count());
        });
    }
    RecordProperty("milliseconds", std::to_string(best));
    // 2 ms is the budget of a release build on a quiet machine; ten times that still notices a wrong
    // complexity.
    EXPECT_LT(best, 20.0);
}

}  // namespace
}  // namespace whorl::app
