// What explanations of advectors are made with, and the list of them.
#pragma once

#include <span>

#include "core/advection/advection.h"
#include "core/base/registry.h"
#include "core/inspect/base_step.h"

namespace whorl {

/// Explains a node that walls leave alone.
class Explainer {
  public:
    /// @param last, out must outlive this
    Explainer(const LastAdvection& last, FieldId quantity, Pool& pool, Explanation& out);

    const SchemeSet& schemes() const { return schemes_; }
    const NamedField& q() const { return q_; }
    const NodeStepper& stepper() const { return stepper_; }
    Explanation& out() { return out_; }
    /// "ρ forward"
    std::string name(const char* which) const { return q_.symbol + " " + which; }

    /// A step of a field at the node, which is drawn under a title.
    NodeStep step(const NamedField& from, Real direction, const char* title);
    /// The same, limited as base steps are.
    NodeStep base_step(const NamedField& from, Real direction, const char* title);
    /// The whole field as the scheme moves it without its limiter; what it leaves on its way is then in the
    /// advection's workspace.
    Field unlimited(Advection& advection);

  private:
    const LastAdvection& last_;
    SchemeSet schemes_;
    NamedField q_;
    NodeStepper stepper_;
    Pool& pool_;
    Explanation& out_;
};

/// A base step that an advector takes: of which field, and in which direction.
struct BasePass {
    enum class Of { Start, Forward, Corrected } field;
    int direction;  ///< −1 traces forward
};

/// How the steps of an advector are explained.
struct AdvectorExplanation {
    std::string_view key;  ///< of the advector
    void (*explain)(Explainer& explainer);
    std::span<const BasePass> passes;  ///< that may be limited on their own; none for a single step

    static Registry<AdvectorExplanation>& list();
};

}  // namespace whorl
