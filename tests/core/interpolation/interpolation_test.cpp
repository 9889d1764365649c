// Interpolations against their definitions: nodes, lines, orders, monotonicity, the bicubic patch.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "core/interpolation/interpolation.h"

namespace whorl {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr Interval inside{5, 20, true};

const Interpolation& scheme(std::string_view key) {
    return Interpolation::list().find(key);
}

/// Any scheme at t between samples 1 and 2 of four.
Real at(const Interpolation& scheme, const std::array<Real, 4>& q, Real t) {
    return scheme.at(q, t, inside);
}

template <class F>
void for_each_interpolation(F&& f) {
    for (const Interpolation* each : Interpolation::list().all()) {
        SCOPED_TRACE(std::string(each->info.key));
        f(*each);
    }
}

TEST(Interpolation, ReproducesItsNodesUnlessItApproximates) {
    for_each_interpolation([](const Interpolation& each) {
        const std::array<Real, 4> q = {3, -1, 4, 1.5};
        if (each.traits.approximates) {
            EXPECT_GT(std::abs(at(each, q, 0) - q[1]), 0.1);
            return;
        }
        EXPECT_NEAR(at(each, q, 0), q[1], 8 * epsilon);
        EXPECT_NEAR(at(each, q, 1), q[2], 16 * epsilon);
    });
}

TEST(Interpolation, ReproducesLines) {
    for_each_interpolation([](const Interpolation& each) {
        const std::array<Real, 4> q = {-1, 1, 3, 5};
        for (int k = 0; k <= 10; ++k) {
            const Real t = Real(k) / 10;
            EXPECT_NEAR(at(each, q, t), 1 + 2 * t, 32 * epsilon) << "t = " << t;
        }
    });
}

/// The order that each scheme's docstring states, measured in double's place by a difference that dwarfs
/// rounding.
double measured_order(const Interpolation& each) {
    const auto worst = [&](int n) {
        double error = 0;
        const double h = 1.0 / n;
        // Where the function is monotone and its slope is not small, so that no limiter acts.
        for (int i = n / 8; i < 3 * n / 8; ++i) {
            const auto f = [](double x) { return std::sin(2 * std::numbers::pi * (x - 0.25)); };
            const std::array<Real, 4> q = {Real(f((i - 1) * h)), Real(f(i * h)), Real(f((i + 1) * h)),
                                           Real(f((i + 2) * h))};
            for (int k = 1; k < 8; ++k) {
                const double t = k / 8.0;
                error = std::max(error, std::abs(static_cast<double>(at(each, q, Real(t))) - f((i + t) * h)));
            }
        }
        return error;
    };
    return std::log2(worst(16) / worst(32));
}

TEST(Interpolation, HasTheOrderItStates) {
    const double slack = 0.25;  // two grids of 16 and 32 are not yet the limit
    for_each_interpolation(
        [slack](const Interpolation& each) { EXPECT_NEAR(measured_order(each), each.traits.order, slack); });
}

/// [T fig 3.5]  The values on one interval of some data, at 1001 points.
std::vector<double> curve_on(std::string_view key, const std::vector<double>& y, std::size_t left) {
    const std::array<Real, 4> q = {Real(y[left - 1]), Real(y[left]), Real(y[left + 1]), Real(y[left + 2])};
    std::vector<double> curve;
    for (int k = 0; k <= 1000; ++k) curve.push_back(static_cast<double>(at(scheme(key), q, Real(k) / 1000)));
    return curve;
}

/// How far a curve falls on its way: 0 for one that only rises.
double largest_fall(const std::vector<double>& curve) {
    double highest = curve.front(), fall = 0;
    for (const double value : curve) {
        highest = std::max(highest, value);
        fall = std::max(fall, highest - value);
    }
    return fall;
}

TEST(Figure35, MonotoneCatmullRomDipsWhereFritschCarlsonDoesNot) {
    const std::vector<double> akima{10, 10, 10, 10, 10, 10, 10.5, 15, 50, 60, 85};
    const double rounding = 100 * static_cast<double>(epsilon);
    EXPECT_GT(largest_fall(curve_on("monotone-catmull-rom", akima, 6)), 0.01);
    EXPECT_GT(largest_fall(curve_on("bridson", akima, 6)), 0.01);
    EXPECT_LE(largest_fall(curve_on("fritsch-carlson", akima, 6)), rounding);
    EXPECT_LE(largest_fall(curve_on("fritsch-carlson-square", akima, 6)), rounding);
}

TEST(Figure35, MonotoneCatmullRomOvershootsWhereFritschCarlsonDoesNot) {
    const std::vector<double> steep{0,        2.76429e-5, 4.37498e-2, 0.169183, 0.469428,
                                    0.943740, 0.998636,   0.999919,   0.999994};
    const auto highest = [](const std::vector<double>& curve) {
        return *std::max_element(curve.begin(), curve.end());
    };
    const double rounding = 8 * static_cast<double>(epsilon);
    EXPECT_GT(highest(curve_on("monotone-catmull-rom", steep, 5)), 0.998636 + 0.0005);
    EXPECT_GT(highest(curve_on("bridson", steep, 5)), 0.998636 + 0.0005);
    EXPECT_LE(highest(curve_on("fritsch-carlson", steep, 5)), 0.998636 + rounding);
    EXPECT_LE(highest(curve_on("fritsch-carlson-square", steep, 5)), 0.998636 + rounding);
}

/// A sample of ordinary size: the squares of slopes must not underflow.
Real sample() {
    return static_cast<Real>(*rc::gen::inRange(-1000000, 1000001)) / 1000;
}

void stays_in_its_interval(std::string_view key) {
    // Slopes of any size and sign: the outer samples set them.
    const Real q0 = sample();
    const Real q1 = *rc::gen::element(q0, sample(), q0 + sample() / 1000);
    const std::array<Real, 4> q = {sample(), q0, q1, sample()};
    const Real rounding =
        32 * epsilon * std::max({std::abs(q[0]), std::abs(q0), std::abs(q1), std::abs(q[3])});
    for (int k = 0; k <= 64; ++k) {
        const Real value = at(scheme(key), q, Real(k) / 64);
        RC_ASSERT(value >= std::min(q0, q1) - rounding);
        RC_ASSERT(value <= std::max(q0, q1) + rounding);
    }
}

RC_GTEST_PROP(FritschCarlson, NeverLeavesItsInterval, ()) {
    stays_in_its_interval("fritsch-carlson");
}
RC_GTEST_PROP(FritschCarlsonSquare, NeverLeavesItsInterval, ()) {
    stays_in_its_interval("fritsch-carlson-square");
}

TEST(MonotoneCatmullRom, FollowsTheFiveCases) {
    // [T A.1]: slopes with D's sign stay, others are 0, and D = 0 gives a constant.
    const Real t = Real(0.3);
    const std::array<Real, 4> flat = {0, 2, 2, 9};
    EXPECT_EQ(at(scheme("monotone-catmull-rom"), flat, t), Real(2));  // C1
    const std::array<Real, 4> peaks = {5, 1, 2, -9};
    EXPECT_NEAR(at(scheme("monotone-catmull-rom"), peaks, t), hermite(Real(1), Real(1), Real(0), Real(0), t),
                4 * epsilon);  // C2
    const std::array<Real, 4> left = {5, 1, 2, 3};
    EXPECT_NEAR(at(scheme("monotone-catmull-rom"), left, t), hermite(Real(1), Real(1), Real(0), Real(1), t),
                4 * epsilon);  // C3
    const std::array<Real, 4> right = {0, 1, 2, -9};
    EXPECT_NEAR(at(scheme("monotone-catmull-rom"), right, t), hermite(Real(1), Real(1), Real(1), Real(0), t),
                4 * epsilon);  // C4
    const std::array<Real, 4> rising = {0, 1, 2, 4};
    EXPECT_NEAR(at(scheme("monotone-catmull-rom"), rising, t), at(scheme("catmull-rom"), rising, t),
                4 * epsilon);  // C5
}

/// [T A.17–A.21] as a linear system, against the tensor product that the code computes.
RC_GTEST_PROP(Bicubic, IsThePatchOfValuesAndDerivatives, ()) {
    double q[4][4];
    for (auto& row : q) {
        for (double& value : row) value = static_cast<double>(sample()) / 1000;
    }
    const double x = *rc::gen::inRange(0, 1001) / 1000.0;
    const double y = *rc::gen::inRange(0, 1001) / 1000.0;
    Eigen::Matrix4d a, f;
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
            const auto at_node = [&](int di, int dj) { return q[j + 1 + dj][i + 1 + di]; };
            a(i, j) = at_node(0, 0);
            a(i, j + 2) = (at_node(0, 1) - at_node(0, -1)) / 2;
            a(i + 2, j) = (at_node(1, 0) - at_node(-1, 0)) / 2;
            a(i + 2, j + 2) = (at_node(1, 1) - at_node(-1, 1) - at_node(1, -1) + at_node(-1, -1)) / 4;
        }
    }
    f << 1, 0, -3, 2, 0, 0, 3, -2, 0, 1, -2, 1, 0, 0, -1, 1;
    const double patch = Eigen::RowVector4d(1, x, x * x, x * x * x) * f.transpose() * a * f *
                         Eigen::Vector4d(1, y, y * y, y * y * y);
    std::array<Real, 4> rows;
    for (std::size_t j = 0; j < 4; ++j) {
        const std::array<Real, 4> row = {Real(q[j][0]), Real(q[j][1]), Real(q[j][2]), Real(q[j][3])};
        rows[j] = at(scheme("bicubic"), row, Real(x));
    }
    RC_ASSERT(std::abs(static_cast<double>(at(scheme("bicubic"), rows, Real(y))) - patch) <
              64.0 * static_cast<double>(epsilon));
}

/// Near walls the B-spline takes rows of its own; the weights of each interval sum to 1 and join smoothly.
TEST(BSpline, IsAPartitionOfUnityUpToTheWalls) {
    for (const int last : {3, 4, 5, 9}) {
        for (int i = 0; i < last; ++i) {
            for (int k = 0; k <= 8; ++k) {
                EXPECT_NEAR(scheme("b-spline").at({1, 1, 1, 1}, Real(k) / 8, {i, last, false}), 1,
                            8 * epsilon)
                    << "interval " << i << " of " << last;
            }
        }
    }
}

TEST(BSpline, IsContinuousAcrossIntervalsNearWalls) {
    const Real q[] = {2, -1, 3, 0.5, 4, -2, 1, 0, 5};
    constexpr int last = 8;
    const auto value = [&](int i, Real t) {
        const auto at_sample = [&](int k) {
            return k < 0 || k > last ? Real(99) : q[k];
        };  // walls hide what is beyond
        return scheme("b-spline")
            .at({at_sample(i - 1), q[i], q[i + 1], at_sample(i + 2)}, t, {i, last, false});
    };
    EXPECT_NEAR(value(0, 0), q[0], 16 * epsilon);  // the boundary sample is met
    EXPECT_NEAR(value(last - 1, 1), q[last], 16 * epsilon);
    for (int i = 0; i + 1 < last; ++i)
        EXPECT_NEAR(value(i, 1), value(i + 1, 0), 16 * epsilon) << "at sample " << i + 1;
}

/// [T table A.3], the rows as printed.
TEST(BSpline, TakesTheTablesRowsAtTheWall) {
    const Real t = Real(0.4);
    const auto weight = [&](int sample, int i) {
        const auto one = [&](int k) { return k == sample ? Real(1) : Real(0); };
        return static_cast<double>(
            scheme("b-spline").at({one(i - 1), one(i), one(i + 1), one(i + 2)}, t, {i, 9, false}));
    };
    const auto boundary01 = [](double x) { return 3 * x * x / 2 * (x / 2 - 1) + 1; };
    const auto boundary12 = [](double x) { return std::pow(2 - x, 3) / 4; };
    const auto external_10 = [](double x) { return std::pow(x + 1, 2) * (7 - 11 * x) / 12; };
    const auto external01 = [](double x) { return (7 * (x * x * x + 1) + 3 * x * (1 - 5 * x)) / 12; };
    const double x = static_cast<double>(t);
    const double rounding = 8 * static_cast<double>(epsilon);
    EXPECT_NEAR(weight(0, 0), boundary01(x), rounding);
    EXPECT_NEAR(weight(0, 1), boundary12(x + 1), rounding);
    EXPECT_NEAR(weight(1, 0), external_10(x - 1), rounding);
    EXPECT_NEAR(weight(1, 1), external01(x), rounding);
    EXPECT_NEAR(weight(1, 2), std::pow(2 - (x + 1), 3) / 6, rounding);
}

}  // namespace
}  // namespace whorl
