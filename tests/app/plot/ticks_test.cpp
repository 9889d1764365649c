// Round numbers along axes.
#include "app/plot/ticks.h"

#include "core/base/number.h"

#include <gtest/gtest.h>

#include <cmath>

namespace whorl::app {
namespace {

std::vector<std::string> labels(const Ticks& ticks) {
    std::vector<std::string> out;
    for (const double value : ticks.values) out.push_back(tick_label(value, ticks));
    return out;
}
using Labels = std::vector<std::string>;

TEST(LinearTicks, AreRoundAndInside) {
    EXPECT_EQ(labels(linear_ticks(0, 520, 5)), (Labels{"0", "100", "200", "300", "400", "500"}));
    EXPECT_EQ(labels(linear_ticks(0, 1, 2)), (Labels{"0.0", "0.5", "1.0"}));
    EXPECT_EQ(labels(linear_ticks(0, 1, 5)), (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
    EXPECT_EQ(labels(linear_ticks(-0.37, 1.93, 5)), (Labels{"0.0", "0.5", "1.0", "1.5"}));
    EXPECT_EQ(labels(linear_ticks(-0.1f, 0.1f, 4)), (Labels{"-0.10", "-0.05", "0.00", "0.05", "0.10"}));
    EXPECT_EQ(labels(linear_ticks(-1, 1, 4)), (Labels{"-1.0", "-0.5", "0.0", "0.5", "1.0"}));
}

TEST(LinearTicks, KeepLongNumbersShort) {
    EXPECT_EQ(labels(linear_ticks(0, 3e-7, 3)), (Labels{"0", "1e-7", "2e-7", "3e-7"}));
    EXPECT_EQ(labels(linear_ticks(0, 4e7, 4)), (Labels{"0", "1e7", "2e7", "3e7", "4e7"}));
    EXPECT_EQ(labels(linear_ticks(1.2e7, 1.4e7, 2)), (Labels{"1.2e7", "1.3e7", "1.4e7"}));
    for (const std::string& label : labels(linear_ticks(1000.0001, 1000.0002, 4)))
        EXPECT_LE(label.size(), 14u);
}

TEST(LinearTicks, AreFewInAnyRange) {
    for (double lo : {-1e30, -7.3, 0.0, 1e-30, 3.0}) {
        for (double size : {1e-6, 0.013, 1.0, 99.0, 1e30}) {
            for (int target : {1, 3, 6}) {
                const Ticks ticks = linear_ticks(lo, lo + size, target);
                EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(2 * target + 1));
                for (const double value : ticks.values) {
                    EXPECT_GE(value, lo - 1e-6 * size);
                    EXPECT_LE(value, lo + size * (1 + 1e-6));
                }
            }
        }
    }
}

TEST(LinearTicks, OfNoRangeAreNone) {
    EXPECT_TRUE(linear_ticks(1, 1, 4).values.empty());
    EXPECT_TRUE(linear_ticks(2, 1, 4).values.empty());
    EXPECT_TRUE(linear_ticks(0, INFINITY, 4).values.empty());
    EXPECT_TRUE(linear_ticks(NAN, 1, 4).values.empty());
}

TEST(LogTicks, ArePowersOfTen) {
    EXPECT_EQ(labels(log_ticks(0.1, 1000, 6)), (Labels{"0.1", "1", "10", "100", "1000"}));
    EXPECT_EQ(labels(log_ticks(1e-9, 1, 4)), (Labels{"1e-9", "1e-6", "1e-3", "1"}));
    EXPECT_EQ(labels(log_ticks(1.5, 30, 4)), (Labels{"2", "5", "10", "20"}));
    EXPECT_TRUE(log_ticks(0, 1, 4).values.empty());
    EXPECT_TRUE(log_ticks(-1, 1, 4).values.empty());
}

TEST(Figure, IsShort) {
    EXPECT_EQ(figure(0.0), "0");
    EXPECT_EQ(figure(-1.5), "−1.5");
    EXPECT_EQ(figure(25310.0), "2.531e4");
    EXPECT_EQ(figure(1.03e-5), "1.03e-5");
    EXPECT_EQ(figure(NAN), "NaN");
    EXPECT_EQ(figure(-INFINITY), "−∞");
    EXPECT_EQ(figure(10000.0, 6), "10000");
}

TEST(Reading, KeepsItsWidth) {
    EXPECT_EQ(reading(24500.0), "2.450e4");
    EXPECT_EQ(reading(1.0), "1.000");
    EXPECT_EQ(reading(1234.0), "1234");
    EXPECT_EQ(reading(0.0), "0");
}

}  // namespace
}  // namespace whorl::app
