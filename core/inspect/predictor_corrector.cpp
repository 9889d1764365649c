#include "core/inspect/predictor_corrector.h"

#include <iterator>

namespace whorl {

CorrectorExplainer::CorrectorExplainer(Explainer& e)
    : explainer(e),
      moved(e.unlimited(advection)),
      start((*e.q().field)(e.out().of_i, e.out().of_j)),
      forward(e.base_step(e.q(), 1, "forward")),
      back(e.base_step({&work().forward[0], e.name("forward")}, -1, "back again")),
      lost((back.value - start) * Real(0.5)) {
    forward.sum.title = e.name("forward");
    back.sum.title = e.name("back");
    e.out().correction = {static_cast<double>(start), static_cast<double>(forward.value),
                          static_cast<double>(back.value), static_cast<double>(lost)};
}

void CorrectorExplainer::finish(std::string_view equation, std::vector<Term> terms, std::vector<Sum> later) {
    const std::string source = thesis_part(explainer.schemes().advector.info().source);
    const NamedField& q = explainer.q();
    Sum error{.title = "error e",
              .equation = source + ", step 3",
              .terms = {{explainer.name("back"), 0.5, static_cast<double>(back.value)},
                        {q.symbol + " before", -0.5, static_cast<double>(start)}},
              .total = static_cast<double>(lost)};
    Sum& sum = explainer.out().sum;
    sum.title = q.symbol + " after advection";
    sum.equation = source + ", " + std::string(equation);
    sum.terms = std::move(terms);
    Real value = moved(explainer.out().of_i, explainer.out().of_j);
    sum.total = static_cast<double>(value);
    explainer.stepper().limit(*q.field, forward.cell, forward.value, sum, value);
    sum.parts = {std::move(forward.sum), std::move(back.sum), std::move(error)};
    std::move(later.begin(), later.end(), std::back_inserter(sum.parts));
}

}  // namespace whorl
