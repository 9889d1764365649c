// The control of a tunable, made from its row in the parameter table.
#pragma once

#include "app/run/run_control.h"
#include "app/ui/ui.h"

namespace whorl::app {

/// Shows and sets values of the run's scene. A change is sent to the run.
class ParameterControls {
  public:
    ParameterControls(Ui& ui, RunControl& run) : ui_(ui), run_(run) {}

    /// A labelled row: slider, list or check box with the parameter's value, its help on hover, and why it is
    /// disabled where it has no effect.
    void row(const Parameter& parameter);
    /// The same, or a pair of controls under the label where velocity and scalars have schemes of their own
    /// and the parameter stands for both. Nothing for the rows of one set alone, and for what only runs
    /// without a window have.
    void row_or_pair(const Parameter& parameter);
    /// row_or_pair for every parameter of a group.
    void rows(Parameter::Group group);

  private:
    /// The control itself, at the cursor and the next item's width.
    void control(const Parameter& parameter);
    void choice(const Parameter& parameter, const char* id);
    /// Numbers that rebuild the domain are sent when the slider is let go, others as it moves.
    void number(const Parameter& parameter, const char* id);
    void help(const Parameter& parameter, const std::string& idle);
    /// Two controls side by side under their label.
    void pair(const Parameter& velocity, const Parameter& scalars);

    Ui& ui_;
    RunControl& run_;
};

}  // namespace whorl::app
