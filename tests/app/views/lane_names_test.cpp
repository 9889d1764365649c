#include "app/views/lane_names.h"

#include <gtest/gtest.h>

namespace whorl::app {
namespace {

TEST(LaneNames, SayWhatDiffersOnce) {
    whorl::Setup setup;
    setup.lanes = {{.name = "A", .overrides = {{"zeta", "1"}}},
                   {.name = {}, .overrides = {{"zeta", "3"}}},
                   {.name = "ζ = 4", .overrides = {{"zeta", "4"}}}};
    LaneNames names;
    names.update(setup);
    EXPECT_EQ(names.name(0), "A");
    EXPECT_EQ(names.difference(0), "ζ = 1");
    EXPECT_EQ(names.name(1), "ζ = 3");
    EXPECT_EQ(names.difference(1), "");
    EXPECT_EQ(names.difference(2), "") << "its name says that already";
}

TEST(LaneNames, OnlyAFinerLaneSaysThatItIs) {
    whorl::Setup setup;
    setup.lanes = {{}, {.name = "fine", .overrides = {{"zeta", "1"}}, .refine = 4}};
    LaneNames names;
    names.update(setup);
    EXPECT_EQ(names.name(0), "ζ = 2");
    EXPECT_EQ(names.difference(1), "ζ = 1 · 4 × finer");
    setup.lanes.resize(1);
    names.update(setup);
    EXPECT_EQ(names.size(), 1u);
    EXPECT_EQ(names.name(0), "Lane 1");
}

}  // namespace
}  // namespace whorl::app
