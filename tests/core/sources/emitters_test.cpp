// What emitters put in.
#include "core/sources/emitters.h"

#include <gtest/gtest.h>

namespace whorl {
namespace {

TEST(Emitters, OpenForJustTheirSteps) {
    const Emitter emitter{.from = 0, .until = 10};
    int open = 0;
    double time = 0;
    for (int step = 0; step < 1200; ++step, time += 1.0 / 60)
        open += is_open(emitter, time, 1.0 / 60) ? 1 : 0;
    EXPECT_EQ(open, 600);
}

TEST(Emitters, HoldTheirValuesAndCountWhatTheyPutIn) {
    State state = make_state({});
    const Emitter emitter{.x = 20,
                          .y = 1,
                          .width = 4,
                          .height = 2,
                          .amounts = {{field::density, 0.5}, {field::temperature, 50}}};
    apply_emitters(state, std::span(&emitter, 1), 0.1);
    EXPECT_EQ(state.density()(18, 0), Real(0.5));
    EXPECT_EQ(state.density()(21, 1), Real(0.5));
    EXPECT_EQ(state.density()(17, 0), 0);
    EXPECT_EQ(state.density()(18, 2), 0);
    EXPECT_EQ(state.temperature()(19, 1), 50);
    EXPECT_NEAR(state.injected[0], 0.5 * 4 * 2, 1e-9);
    apply_emitters(state, std::span(&emitter, 1), 0.1);
    EXPECT_NEAR(state.injected[0], 0.5 * 4 * 2, 1e-9) << "holding adds nothing";
}

}  // namespace
}  // namespace whorl
