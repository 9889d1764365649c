#include "app/charts/plots_csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace whorl::app {
namespace {

TEST(PlotsCsv, HasARowAStepAndLane) {
    History history;
    for (long step = 0; step < 3; ++step) {
        Measures m;
        m.time = 0.5 * static_cast<double>(step);
        m.percent = {98};
        m.kinetic_energy = 7;
        m.errors.L1 = std::numeric_limits<double>::quiet_NaN();
        StepMeasures row{step, {4}, {m}};
        if (step > 0) row = {step, {4, 9}, {m, m}};
        history.take({&row, 1}, false);
    }
    const std::string csv = plots_csv({{"SL, \"plain\"", history.lane(4)}, {"late", history.lane(9)}});
    EXPECT_TRUE(csv.starts_with("step,time,lane,title,density_percent,kinetic_energy,"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 + 2);
    EXPECT_NE(csv.find("\n1,0.5,1,\"SL, \"\"plain\"\"\",98,7,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\n1,0.5,2,late,98,7,"), std::string::npos);
    EXPECT_EQ(csv.find("nan"), std::string::npos) << "what is not known stays empty";
}

}  // namespace
}  // namespace whorl::app
