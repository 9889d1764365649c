// The labs: what they compute, and that it is the solver's.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/labs/data_sets.h"
#include "app/labs/field_sampling.h"
#include "app/labs/interval_report.h"
#include "app/labs/monotone_region.h"
#include "app/labs/weight_profile.h"
#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

constexpr double epsilon = std::numeric_limits<Real>::epsilon();

IntervalReport of_figure(std::string_view key, std::size_t data_set, bool clamped = false) {
    const DataSet& data = data_sets()[data_set];
    return report_on(row_of(data.values), Id<Interpolation>(key), clamped, data.interval);
}

TEST(InterpolationLab, SaysWhatFigure35Says) {
    // (a): monotone Catmull-Rom has a slight trough, Bridson's cubic undershoots, between 6 and 7.
    EXPECT_EQ(data_sets()[0].interval, 6);
    EXPECT_GT(of_figure("monotone-catmull-rom", 0).turned, 0.1);
    EXPECT_FALSE(of_figure("monotone-catmull-rom", 0).leaves_range());
    EXPECT_GT(of_figure("bridson", 0).below, 0.1);
    // (b): both overshoot between 5 and 6.
    EXPECT_EQ(data_sets()[1].interval, 5);
    EXPECT_GT(of_figure("monotone-catmull-rom", 1).above, 0.001);
    EXPECT_GT(of_figure("bridson", 1).above, 0.001);
    // In both, Fritsch and Carlson's neither overshoots nor turns.
    for (const std::size_t set : {0u, 1u}) {
        for (const IntervalReport& report :
             {of_figure("fritsch-carlson", set), of_figure("fritsch-carlson-square", set),
              of_figure("linear", set)})
            EXPECT_EQ(report.verdict(), "monotone");
    }
    // It interpolates, and the B-spline approximates.
    const Field row = row_of(data_sets()[0].values);
    const std::array<glm::dvec2, 1> node{glm::dvec2(7, 0)};
    std::array<float, 1> value;
    SchemeSet schemes;
    schemes.interpolation = Id<Interpolation>("fritsch-carlson");
    sample_field(row, schemes, Wraps{}, node, value);
    EXPECT_EQ(value[0], 15);
    schemes.interpolation = Id<Interpolation>("b-spline");
    sample_field(row, schemes, Wraps{}, node, value);
    EXPECT_GT(std::abs(value[0] - 15.0f), 1.0f);
}

TEST(InterpolationLab, ClampingKeepsTheRange) {
    for (std::size_t set = 0; set < data_sets().size(); ++set) {
        const DataSet& data = data_sets()[set];
        const Field row = row_of(data.values);
        for (std::size_t k = 0; k < Interpolation::list().all().size(); ++k) {
            for (int i = 0; i + 1 < row.width(); ++i)
                EXPECT_FALSE(report_on(row, Id<Interpolation>::at(k), true, i).leaves_range());
        }
    }
}

TEST(InterpolationLab, SlopesAreThoseOfTheThesis) {
    // Akima's data, interval 6: D = 4.5, δ = (15 − 10)/2 and (50 − 10.5)/2; the circle scales both to 3.
    const double alpha = 2.5 / 4.5, beta = 19.75 / 4.5, tau = 3 / std::hypot(alpha, beta);
    // The slopes are 24ths of sums of samples of size 50, times 192, over D.
    const double rounding = 192.0 / 24 * 4 * 50 / 4.5 * epsilon;
    EXPECT_NEAR(of_figure("monotone-catmull-rom", 0).alpha, alpha, rounding);
    EXPECT_NEAR(of_figure("monotone-catmull-rom", 0).beta, beta, rounding);
    EXPECT_NEAR(of_figure("fritsch-carlson", 0).alpha, tau * alpha, rounding);
    EXPECT_NEAR(of_figure("fritsch-carlson", 0).beta, tau * beta, rounding);
    EXPECT_NEAR(of_figure("fritsch-carlson-square", 0).beta, 3, rounding);
    EXPECT_NEAR(of_figure("linear", 0).alpha, 1, rounding);
}

TEST(InterpolationLab, RegionsBoundaryIsWhereItEnds) {
    for (int k = 1; k < 100; ++k) {
        const glm::dvec2 at = region_boundary(k / 100.0);
        const glm::dvec2 out = 1e-6 * (at - glm::dvec2(1, 1));
        EXPECT_TRUE(is_monotone(at.x - out.x, at.y - out.y)) << at.x << ' ' << at.y;
        EXPECT_FALSE(is_monotone(at.x + out.x, at.y + out.y)) << at.x << ' ' << at.y;
    }
    EXPECT_TRUE(is_monotone(0, 0));
    EXPECT_TRUE(is_monotone(3, 0));
    EXPECT_TRUE(is_monotone(0, 3));
    EXPECT_FALSE(is_monotone(3.1, 0));
    EXPECT_FALSE(is_monotone(-0.1, 1));
}

RC_GTEST_PROP(InterpolationLab, ACurveIsMonotoneExactlyWhereItsSlopesLieInTheRegion, ()) {
    std::vector<float> values;
    for (int k = 0; k < 8; ++k) values.push_back(static_cast<float>(*rc::gen::inRange(-20, 21)));
    const Field row = row_of(values);
    const int i = *rc::gen::inRange(0, 7);
    for (std::size_t k = 0; k < Interpolation::list().all().size(); ++k) {
        const auto id = Id<Interpolation>::at(k);
        if (id == Id<Interpolation>("b-spline")) continue;  // leaves its points' range by approximating
        const IntervalReport report = report_on(row, id, false, i);
        if (report.flat) continue;
        const bool monotone = is_monotone(report.alpha, report.beta);
        // Too near the boundary a reversal is smaller than what samples show.
        constexpr double near = 0.1;
        bool clear = true;
        for (const double a : {-near, near}) {
            for (const double b : {-near, near})
                clear &= is_monotone(report.alpha + a, report.beta + b) == monotone;
        }
        if (clear) RC_ASSERT((report.verdict() == "monotone") == monotone);
        if (id == Id<Interpolation>("fritsch-carlson") || id == Id<Interpolation>("fritsch-carlson-square"))
            RC_ASSERT(report.verdict() == "monotone");
    }
}

RC_GTEST_PROP(InterpolationLab, CurvesAreTheSchemesOwn, ()) {
    std::vector<float> values;
    for (int k = 0; k < 9; ++k) values.push_back(0.1f * static_cast<float>(*rc::gen::inRange(-99, 100)));
    const Field row = row_of(values);
    const int i = *rc::gen::inRange(2, 5);
    const int part = *rc::gen::inRange(0, 64);
    const std::array<glm::dvec2, 1> place{glm::dvec2(i + part / 64.0, 0)};
    const auto t = static_cast<Real>(part / 64.0);
    for (std::size_t k = 0; k < Interpolation::list().all().size(); ++k) {
        SchemeSet schemes;
        schemes.interpolation = Id<Interpolation>::at(k);
        std::array<float, 1> value;
        sample_field(row, schemes, Wraps{}, place, value);
        const whorl::Interval in{i, row.width() - 1, false};
        const Real expected =
            schemes.interpolation->at({row(i - 1, 0), row(i, 0), row(i + 1, 0), row(i + 2, 0)}, t, in);
        RC_ASSERT(value[0] == static_cast<float>(expected));
    }
}

double length(Vec2 offset) {
    return std::hypot(static_cast<double>(offset.x), static_cast<double>(offset.y));
}

std::size_t particles_in_table_41(Id<StencilShape> kind, std::size_t zeta, int dimensions) {
    const std::size_t side = kind == Id<StencilShape>("subsampling") ? zeta + 1 : 2 * zeta + 1;
    if (dimensions == 1) return side;
    // The Delannoy number of 2 and ζ.
    return kind == Id<StencilShape>("manhattan") ? 2 * zeta * zeta + 2 * zeta + 1 : side * side;
}

TEST(StencilLab, ParticlesAreThoseOfTable41AndLieOnTheProfile) {
    for (std::size_t kind = 0; kind < StencilShape::list().all().size(); ++kind) {
        for (std::size_t weights = 0; weights < WeightKernel::list().all().size(); ++weights) {
            for (const int dimensions : {1, 2}) {
                for (int zeta = 1; zeta <= SchemeSet::max_zeta; ++zeta) {
                    const auto id = Id<StencilShape>::at(kind);
                    const Stencil stencil(id, zeta, Id<WeightKernel>::at(weights), dimensions, 7);
                    const WeightProfile profile(stencil, dimensions, Id<WeightKernel>::at(weights));
                    EXPECT_EQ(stencil.particles().size(),
                              particles_in_table_41(id, static_cast<std::size_t>(zeta), dimensions));
                    double sum = 0;
                    for (const Particle& particle : stencil.particles()) {
                        const auto weight = static_cast<double>(particle.weight);
                        sum += weight;
                        // Offsets and weights are rounded to Real; SPH's third power triples what r has.
                        EXPECT_NEAR(profile(length(particle.offset)), weight, 8 * epsilon * weight);
                    }
                    EXPECT_NEAR(sum, 1, epsilon * static_cast<double>(stencil.particles().size()));
                }
            }
        }
    }
}

TEST(StencilLab, SphWeightsOfACellsCornersAreATenthOfTheNodesAtLeast) {
    const Stencil stencil(Id<StencilShape>("chessboard"), 2, Id<WeightKernel>("sph"), 2, 1);
    const WeightProfile profile(stencil, 2, Id<WeightKernel>("sph"));
    const double ratio = profile(Stencil::radius(2)) / profile(0);
    EXPECT_NEAR(ratio, std::pow(1 - 1 / (1.5 * 1.5), 3), 1e-12);  // [T 4.7], in doubles
    EXPECT_GE(ratio, 0.1);
}

}  // namespace
}  // namespace whorl::app
