#include "app/panels/history.h"

#include <gtest/gtest.h>

namespace whorl::app {
namespace {

StepMeasures at_step(long step) {
    Measures m;
    m.step = step;
    m.kinetic_energy = static_cast<double>(step);
    return {step, {7}, {m}};
}

TEST(History, StaysSmallAndCoversALongRun) {
    History history;
    for (long step = 0; step <= 100'000; ++step) {
        const StepMeasures m = at_step(step);
        history.take({&m, 1}, 7, step == 0);
    }
    EXPECT_LE(history.steps().size(), History::capacity);
    EXPECT_GT(history.steps().size(), History::capacity / 3);
    EXPECT_EQ(history.steps().front(), 0);
    EXPECT_GT(history.steps().back(), 99'900);
    for (std::size_t k = 0; k < history.steps().size(); ++k) {
        ASSERT_EQ(history.of(Track::KineticEnergy)[k], history.steps()[k]) << "each sample keeps its step";
    }
    EXPECT_EQ(history.last().step, 100'000);
}

TEST(History, ForgetsTheRunBefore) {
    History history;
    const StepMeasures old[] = {at_step(0), at_step(1), at_step(2)};
    history.take(old, 7, true);
    const StepMeasures fresh[] = {at_step(0)};
    history.take(fresh, 7, true);
    EXPECT_EQ(history.steps().size(), 1u);
}

}  // namespace
}  // namespace whorl::app
