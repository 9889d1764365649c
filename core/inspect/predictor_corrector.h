// What the explanations of MacCormack and BFECC share: the step forward, the step back, and the error.
#pragma once

#include <vector>

#include "core/inspect/explainer.h"

namespace whorl {

class CorrectorExplainer {
  public:
    explicit CorrectorExplainer(Explainer& explainer);

    Explainer& explainer;
    Advection advection;
    Field moved;  ///< by the whole scheme, unlimited
    Real start;
    NodeStep forward, back;
    Real lost;  ///< half of what the way forward and back did

    const Workspace& work() const { return *advection.workspace(); }
    /// Limits the value, and sets the whole sum: its parts are forward, back, error, and `later`.
    void finish(std::string_view equation, std::vector<Term> terms, std::vector<Sum> later);
};

}  // namespace whorl
