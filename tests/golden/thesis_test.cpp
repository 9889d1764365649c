// The thesis' printed numbers and its statements about them.
#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/parameters.h"
#include "core/simulation/simulation.h"

namespace whorl {
namespace {

Measures run(const std::string& name, const std::vector<std::string>& settings, long steps) {
    Scene scene = scene_of(experiment(name));
    for (const std::string& setting : settings) set_parameter(scene, setting);
    Pool pool(2);
    Simulation simulation(scene, pool);
    while (simulation.state().step < steps) simulation.step();
    return simulation.measures();
}

const std::vector<std::string> sl_lin{"advector=semi-lagrangian"};
const std::vector<std::string> sl_fc{"advector=semi-lagrangian", "interpolation=fritsch-carlson"};
const std::vector<std::string> mc_lin{"advector=maccormack"};
const std::vector<std::string> mc_fc{"advector=maccormack", "interpolation=fritsch-carlson"};
const std::vector<std::string> aslam{"advector=aslam"};
const std::vector<std::string> aslam_0{"advector=aslam-0"};

/// Table 5.2: rotation, ASLAM, ζ = 2, SPH, step 1200; the rates between this row and the one above it.
struct PrintedRow {
    int resolution;
    Errors errors;
    Errors rates;
};
constexpr PrintedRow table_5_2[] = {
    {40, {7.591e+01, 4.869e+00, 6.173e-01}, {}},
    {80, {4.109e+01, 3.073e+00, 4.228e-01}, {8.856e-01, 6.641e-01, 5.460e-01}},
    {160, {1.930e+01, 1.618e+00, 2.503e-01}, {1.090e+00, 9.256e-01, 7.562e-01}},
    {320, {8.838e+00, 7.880e-01, 1.234e-01}, {1.127e+00, 1.038e+00, 1.020e+00}},
};
/// The thesis prints four digits of a run of another program.
constexpr double share = 0.005;
/// What that share of two errors can make of a rate: log2(1.005 / 0.995).
constexpr double rate_slack = 0.0145;

TEST(Table52, IsReproducedWithItsRates) {
    Errors last{};
    for (const PrintedRow& row : table_5_2) {
        SCOPED_TRACE("N = " + std::to_string(row.resolution));
        const Errors e =
            run("rotation", {"advector=aslam", "resolution=" + std::to_string(row.resolution)}, 1200).errors;
        for (double Errors::*norm : {&Errors::L1, &Errors::L2, &Errors::Linf}) {
            EXPECT_NEAR(e.*norm, row.errors.*norm, share * row.errors.*norm);
            if (std::isnan(row.rates.*norm)) continue;  // of the first row
            EXPECT_NEAR(std::log2(last.*norm / e.*norm), row.rates.*norm, rate_slack);
        }
        last = e;
    }
}

TEST(Thesis, MacCormackGainsDensityUnderTranslation) {
    EXPECT_GT(run("translation", mc_lin, 1200).density_percent(), 140);  // [T fig 5.17]
    EXPECT_GT(run("translation", mc_fc, 1200).density_percent(), 180);
}

TEST(Thesis, RotationOrdersTheSchemes) {  // [T sec 5.3, fig 5.19]
    const Errors sl = run("rotation", sl_lin, 1200).errors;
    const Errors as = run("rotation", aslam, 1200).errors;
    EXPECT_LT(as.L2, sl.L2);
    EXPECT_LT(as.Linf, sl.Linf);
    EXPECT_GT(as.L1, sl.L1);
    const Errors lin = run("rotation", mc_lin, 1200).errors;
    const Errors fc = run("rotation", mc_fc, 1200).errors;
    EXPECT_LT(lin.Linf, fc.Linf);
    EXPECT_GT(lin.L1, fc.L1);
    EXPECT_GT(lin.L2, fc.L2);
}

TEST(Thesis, GradientsAreWhatHelpsInAslam) {  // [T sec 5.5, fig 5.22]
    for (const char* name : {"translation", "rotation"}) {
        SCOPED_TRACE(name);
        const Measures sl = run(name, sl_lin, 60);
        const Measures zero = run(name, aslam_0, 60);
        const Measures as = run(name, aslam, 60);
        EXPECT_LT(zero.max_density, sl.max_density);
        EXPECT_GT(as.max_density, zero.max_density);
    }
}

TEST(Thesis, LargerStencilsErrLessAndConserveWorse) {  // [T sec 5.2, fig 5.11, B.5, B.6]
    for (const char* name : {"translation", "rotation"}) {
        SCOPED_TRACE(name);
        Measures last = run(name, {"advector=aslam", "zeta=1"}, 1200);
        for (int zeta = 2; zeta <= 4; ++zeta) {
            const Measures m = run(name, {"advector=aslam", "zeta=" + std::to_string(zeta)}, 1200);
            EXPECT_LT(m.errors.L2, last.errors.L2) << "ζ = " << zeta;
            EXPECT_GT(std::abs(m.density_percent() - 100), std::abs(last.density_percent() - 100))
                << "ζ = " << zeta;
            last = m;
        }
    }
}

TEST(Rest, IsTheIdentityOfSemiLagrangianAndOfAslamBilinear) {
    const double floor = 1e-4;  // Σ|q−Q| over 1600 cells after 1200 steps: rounding alone
    EXPECT_LT(run("rest", sl_lin, 1200).errors.L1, floor);
    EXPECT_LT(run("rest", {"advector=aslam-bilinear"}, 1200).errors.L1, floor);
}

TEST(Rest, AslamSquaresByItsCrossDifference) {
    EXPECT_NEAR(run("rest", aslam, 1200).errors.L1, 62.8, 0.005 * 62.8);
    EXPECT_NEAR(run("rotation", {"advector=aslam-bilinear"}, 1200).errors.L1, 47.1, 0.005 * 47.1);
}

/// The plume's α, β and emitter are ours, chosen so that this holds.
TEST(Plume, HeadReachesTheLidBetweenSteps360And480) {
    Scene scene = scene_of(experiment("plume"));
    Pool pool(2);
    Simulation simulation(scene, pool);
    const double visible = 0.1 * scene.emitters[0].amounts[field::density];
    long reached = 0;
    while (reached == 0 && simulation.state().step < 600) {
        simulation.step();
        const Field& density = simulation.state().density();
        for (int i = 0; i < density.width(); ++i) {
            if (static_cast<double>(density(i, density.height() - 1)) > visible)
                reached = simulation.state().step;
        }
    }
    EXPECT_GE(reached, 360);
    EXPECT_LE(reached, 480);
}

/// The exact flow is steady: what is lost is the scheme's. Less dissipative schemes keep more.
TEST(TaylorGreen, LosesEnergyByTheSchemeAlone) {
    const auto kept = [](const std::vector<std::string>& settings) {
        std::vector<std::string> all = settings;
        all.push_back("resolution=32");
        return run("taylor-green", all, 200).kinetic_energy / run("taylor-green", all, 0).kinetic_energy;
    };
    const double sl = kept(sl_lin);
    const double mc = kept(mc_lin);
    const double fc = kept(sl_fc);
    EXPECT_LT(sl, fc);
    EXPECT_LT(fc, mc);
    EXPECT_LT(mc, 1.001);
    EXPECT_GT(mc, 0.95);
}

}  // namespace
}  // namespace whorl
