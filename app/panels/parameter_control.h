// The control of a tunable, made from its row in the parameter table.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// A labelled row: slider, list or check box with the parameter's value, its help on tooltip, and why it is
/// disabled where it has no effect. A change is sent to the run.
void parameter_row(PanelContext& context, const Parameter& parameter);

/// The same, or a pair of controls under the label where velocity and scalars have schemes of their own and
/// the parameter stands for both. Nothing for the rows of one set alone, and for what only runs without a
/// window have.
void parameter_or_pair(PanelContext& context, const Parameter& parameter);

/// parameter_or_pair for every parameter of a group.
void parameter_rows(PanelContext& context, Parameter::Group group);

}  // namespace whorl::app
