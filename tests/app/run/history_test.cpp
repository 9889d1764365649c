#include "app/run/history.h"

#include <gtest/gtest.h>

#include <cmath>

namespace whorl::app {
namespace {

const Measure& energy() {
    return measures().find("kinetic_energy");
}

/// A row whose lanes have the energy 1000 · id + step.
StepMeasures at_step(long step, std::vector<int> ids = {7}) {
    StepMeasures row{step, ids, {}};
    for (const int id : ids) {
        Measures m;
        m.step = step;
        m.kinetic_energy = static_cast<double>(1000 * id + step);
        row.lanes.push_back(m);
    }
    return row;
}

void take(History& history, long first, long last, const std::vector<int>& ids) {
    for (long step = first; step <= last; ++step) {
        const StepMeasures row = at_step(step, ids);
        history.take({&row, 1}, false);
    }
}

void expect_samples_of(const LaneHistory& lane, int id) {
    for (std::size_t k = 0; k < lane.steps.size(); ++k) {
        ASSERT_EQ(lane.of(energy())[k], static_cast<float>(1000 * id) + lane.steps[k]);
        if (k > 0) {
            ASSERT_GT(lane.steps[k], lane.steps[k - 1]);
        }
    }
}

TEST(History, KnowsTheMedianOfTheLastSteps) {
    History history;
    EXPECT_TRUE(std::isnan(history.lane(7).median(energy(), 60)));
    take(history, 0, 2, {7});
    EXPECT_EQ(history.lane(7).median(energy(), 60), 7001);
    take(history, 3, 100, {7});
    EXPECT_EQ(history.lane(7).median(energy(), 5), 7098);
}

TEST(History, StaysSmallAndCoversALongRun) {
    History history;
    take(history, 0, 100'000, {7});
    const LaneHistory& lane = history.lane(7);
    EXPECT_LE(lane.steps.size(), History::capacity);
    EXPECT_GT(lane.steps.size(), History::capacity / 3);
    EXPECT_EQ(lane.steps.front(), 0);
    EXPECT_GT(lane.steps.back(), 99'900);
    expect_samples_of(lane, 7);
    EXPECT_EQ(lane.last.step, 100'000);
}

TEST(History, ForgetsTheRunBefore) {
    History history;
    take(history, 0, 2, {7});
    const StepMeasures fresh = at_step(0, {8});
    history.take({&fresh, 1}, true);
    EXPECT_TRUE(history.lane(7).steps.empty());
    EXPECT_EQ(history.lane(8).steps.size(), 1u);
}

TEST(History, KnowsLanesByTheirIdWhereverTheyMove) {
    History history;
    take(history, 0, 9, {0, 1});
    take(history, 10, 19, {5, 1, 0});
    take(history, 20, 29, {5, 0});
    EXPECT_EQ(history.lane(0).steps.size(), 30u);
    EXPECT_EQ(history.lane(1).steps.size(), 20u) << "it was removed";
    EXPECT_EQ(history.lane(5).steps.size(), 20u);
    EXPECT_EQ(history.lane(5).steps.front(), 10) << "it was added later";
    EXPECT_TRUE(history.lane(2).steps.empty());
    for (const int id : {0, 1, 5}) expect_samples_of(history.lane(id), id);
}

TEST(History, GoingBackTakesAwayWhatCameAfter) {
    History history;
    take(history, 0, 50, {0, 1});
    take(history, 51, 60, {0, 1, 2});
    take(history, 40, 45, {0, 1});
    for (const int id : {0, 1}) {
        EXPECT_EQ(history.lane(id).steps.size(), 46u);
        EXPECT_EQ(history.lane(id).last.step, 45);
        expect_samples_of(history.lane(id), id);
    }
    EXPECT_TRUE(history.lane(2).steps.empty()) << "it is not there yet";
}

TEST(History, LanesAreThinnedTogether) {
    History history;
    const auto more = static_cast<long>(History::capacity) + 100;
    take(history, 0, 5000, {0});
    take(history, 5001, more, {0, 1});
    EXPECT_LE(history.lane(0).steps.size(), History::capacity);
    const auto& late = history.lane(1).steps;
    EXPECT_EQ(late.size(), static_cast<std::size_t>((more - 5000) / 2)) << "at the same steps";
    expect_samples_of(history.lane(0), 0);
    expect_samples_of(history.lane(1), 1);
}

}  // namespace
}  // namespace whorl::app
