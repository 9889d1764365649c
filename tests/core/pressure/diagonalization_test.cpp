// The modes and the product that fast diagonalisation is made of.
#include <gtest/gtest.h>

#include "core/pressure/gemm.h"
#include "core/pressure/modes.h"
#include "tests/core/pressure/domains.h"

namespace whorl::test {
namespace {

/// Rounding of sums of a few hundred products of numbers below 1.
constexpr double rounding = 1e-12;

TEST(Modes, AreEigenvectorsOfLengthOne) {
    for (const bool periodic : {false, true}) {
        for (const int n : {2, 3, 4, 5, 16, 33}) {
            const Modes all = modes(n, periodic);
            EXPECT_EQ(all.even.count + all.odd.count, n);
            for (const bool odd : {false, true}) {
                const ModeSet& set = odd ? all.odd : all.even;
                for (int k = 0; k < set.count; ++k) {
                    const auto value = [&](int i) {
                        if (periodic) {
                            i = (i + n) % n;
                        } else {
                            i = std::clamp(i, 0, n - 1);
                        }
                        const int m = std::min(i, n - 1 - i);
                        if (m >= set.count) return 0.0;  // the middle cell of an odd mode
                        const double v = set.values[static_cast<std::size_t>(m) * set.count + k];
                        return odd && i > n - 1 - i ? -v : v;
                    };
                    double square = 0;
                    for (int i = 0; i < n; ++i) {
                        square += value(i) * value(i);
                        EXPECT_NEAR(2 * value(i) - value(i - 1) - value(i + 1), set.eigenvalues[k] * value(i),
                                    rounding)
                            << n << (periodic ? " periodic" : " box") << " mode " << k << " cell " << i;
                    }
                    EXPECT_NEAR(square, 1, rounding);
                }
            }
        }
    }
}

TEST(Product, IsTheSameBitsAsAPlainSum) {
    std::mt19937 random(1);
    for (const auto& [rows, inner] : {std::pair(1, 1), {5, 3}, {12, 16}, {29, 40}}) {
        const int stride = inner + 3;
        std::vector<double> left(static_cast<std::size_t>(rows) * stride);
        std::vector<double> panel(static_cast<std::size_t>(inner) * panel_width);
        for (double& x : left) x = std::generate_canonical<double, 32>(random) - 0.5;
        for (double& x : panel) x = std::generate_canonical<double, 32>(random) - 0.5;
        std::vector<double> out(static_cast<std::size_t>(rows) * panel_width);
        multiply(left.data(), stride, panel.data(), inner, out.data(), panel_width, rows);
        for (int r = 0; r < rows; ++r) {
            for (int c = 0; c < panel_width; ++c) {
                double sum = 0;
                for (int k = 0; k < inner; ++k) sum += left[r * stride + k] * panel[k * panel_width + c];
                EXPECT_EQ(out[r * panel_width + c], sum);
            }
        }
    }
}

}  // namespace
}  // namespace whorl::test
