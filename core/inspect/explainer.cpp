#include "core/inspect/explainer.h"

namespace whorl {

Explainer::Explainer(const LastAdvection& last, FieldId quantity, Pool& pool, Explanation& out)
    : last_(last),
      schemes_(last.setup.schemes(quantity)),
      q_{last.from(quantity), std::string(quantity.info().symbol)},
      stepper_(schemes_, last),
      pool_(pool),
      out_(out) {}

NodeStep Explainer::step(const NamedField& from, Real direction, const char* title) {
    NodeStep step = stepper_.step(from, out_.of_i, out_.of_j, direction);
    step.drawn.title = title;
    out_.steps.push_back(step.drawn);
    return step;
}

NodeStep Explainer::base_step(const NamedField& from, Real direction, const char* title) {
    NodeStep base = step(from, direction, title);
    stepper_.limit_base(*from.field, base);
    return base;
}

Field Explainer::unlimited(Advection& advection) {
    SchemeSet schemes = schemes_;
    schemes.limiter = no_limiter;
    advection.set({schemes, last_.boundary->grid().dimensions(), last_.setup.seed});
    Field moved = last_.boundary->field(q_.field->site());
    advection.advect(*q_.field, moved, {last_.velocity, last_.boundary, &pool_, last_.setup.dt});
    return moved;
}

}  // namespace whorl
