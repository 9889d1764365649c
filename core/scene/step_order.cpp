#include "core/scene/step_order.h"

namespace whorl {

Registry<StepOrder>& step_orders() {
    static const StepOrder thesis{{"thesis", "Thesis", "thesis alg. 2.1",
                                   "Forces, projection, advection: what moves is divergence-free."},
                                  {{"forces"}, {"projection"}, {"advection"}}};
    static const StepOrder smoke{{"smoke", "Smoke paper", "Fedkiw, Stam and Jensen 2001, eq. 14",
                                  "Forces, advection, projection: what is left is divergence-free."},
                                 {{"forces"}, {"advection"}, {"projection"}}};
    static Registry<StepOrder> all("step order", {&thesis, &smoke});
    return all;
}

const StepOrder prescribed_order{
    {"prescribed", "Prescribed flow", "", "The flow is given; the density moves."},
    {{"prescribe"}, {"advection"}}};

}  // namespace whorl
