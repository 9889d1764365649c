// The explanation of MacCormack.
#include "core/inspect/predictor_corrector.h"

namespace whorl {
namespace {

void explain(Explainer& explainer) {
    CorrectorExplainer c(explainer);
    c.finish("eq. 3.26",
             {{explainer.name("forward"), 1, static_cast<double>(c.forward.value)},
              {"error e", -1, static_cast<double>(c.lost)}},
             {});
}

constexpr BasePass passes[] = {{BasePass::Of::Start, 1}, {BasePass::Of::Forward, -1}};

}  // namespace

extern constinit const AdvectorExplanation of_maccormack{"maccormack", explain, passes};

}  // namespace whorl
