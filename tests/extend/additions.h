// What only tests know: one entry of each kind that the program has a list of.
#pragma once

#include "app/run/panel.h"
#include "app/run/tool.h"
#include "app/views/views.h"
#include "core/derived/derived.h"
#include "core/measure/measure.h"
#include "core/scene/field_list.h"
#include "core/scene/phase.h"
#include "core/scene/step_order.h"
#include "core/sources/edit.h"

namespace whorl::test {

/// The scalar that is added.
FieldId dye();

extern const FieldInfo dye_info;
extern const Measure dye_height;
extern const app::View root_density;
extern const DerivedField kinetic;
extern const Phase friction;
extern const StepOrder rough;
extern const EditVerb drop;
extern const app::ToolEntry dropper;
extern const app::PanelEntry dye_panel;

}  // namespace whorl::test
