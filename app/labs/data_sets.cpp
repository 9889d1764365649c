#include "app/labs/data_sets.h"

namespace whorl::app {

std::span<const DataSet> data_sets() {
    static constexpr float akima[] = {10, 10, 10, 10, 10, 10, 10.5f, 15, 50, 60, 85};
    static constexpr float fritsch_carlson[] = {0,         2.76429e-5f, 4.37498e-2f, 0.169183f, 0.469428f,
                                                0.943740f, 0.998636f,   0.999919f,   0.999994f};
    static constexpr float step[] = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
    static constexpr float spike[] = {0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0};
    static constexpr float ramp[] = {0, 0, 0, 0.25f, 0.5f, 0.75f, 1, 1, 1, 1};
    static constexpr DataSet table[] = {
        {"akima", "Figure 3.5 a",
         "Between 6 and 7 monotone Catmull-Rom turns back although the data rise, and Bridson's cubic falls "
         "below them.",
         "Akima 1970, first example, evenly spaced; thesis fig. 3.5a", akima, 6},
        {"fritsch-carlson", "Figure 3.5 b",
         "Between 5 and 6 monotone Catmull-Rom and Bridson's cubic rise above the data.",
         "Fritsch and Carlson 1980, second example, evenly spaced; thesis fig. 3.5b", fritsch_carlson, 5},
        {"step", "Step", "An edge: cubics with free slopes overshoot beside it.", "", step, 5},
        {"spike", "Spike", "One sample that stands out: what is left of it half-way is what a step costs.",
         "", spike, 4},
        {"ramp", "Ramp", "A slope between two plains: only its corners tell interpolations apart.", "", ramp,
         6},
    };
    return table;
}

}  // namespace whorl::app
