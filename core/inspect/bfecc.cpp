// The explanation of BFECC.
#include "core/inspect/predictor_corrector.h"

namespace whorl {
namespace {

void explain(Explainer& explainer) {
    CorrectorExplainer c(explainer);
    const Field& corrected = c.work().corrected[0];
    const std::string name = explainer.name("corrected");
    NodeStep last = explainer.base_step({&corrected, name}, 1, "forward, corrected");
    last.sum.title = name + ", moved forward";
    Sum at_node{.title = name + " at the node",
                .equation = "thesis alg. 3.2, step 4",
                .terms = {{explainer.q().symbol + " before", 1, static_cast<double>(c.start)},
                          {"error e", -1, static_cast<double>(c.lost)}},
                .total = static_cast<double>(corrected(explainer.out().of_i, explainer.out().of_j))};
    const Term moved{last.sum.title, 1, static_cast<double>(last.value)};
    c.finish("step 5", {moved}, {std::move(at_node), std::move(last.sum)});
}

constexpr BasePass passes[] = {
    {BasePass::Of::Start, 1}, {BasePass::Of::Forward, -1}, {BasePass::Of::Corrected, 1}};

}  // namespace

extern constinit const AdvectorExplanation of_bfecc{"bfecc", explain, passes};

}  // namespace whorl
