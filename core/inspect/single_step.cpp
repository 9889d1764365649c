// The explanation of advectors that take a single step.
#include "core/inspect/explainer.h"

namespace whorl {
namespace {

void explain(Explainer& explainer) {
    const NamedField& q = explainer.q();
    NodeStep forward = explainer.step(q, 1, "back along the flow");
    if (explainer.schemes().advector->traits.limited) {
        explainer.stepper().limit(*q.field, forward.cell, forward.first_order, forward.sum, forward.value);
    }
    explainer.out().sum = std::move(forward.sum);
}

}  // namespace

extern constinit const AdvectorExplanation of_semi_lagrangian{"semi-lagrangian", explain, {}},
    of_aslam{"aslam", explain, {}}, of_aslam_zero{"aslam-0", explain, {}},
    of_aslam_bilinear{"aslam-bilinear", explain, {}};

}  // namespace whorl
