// Emitters: places that hold scalars at their amounts while they are open.
#pragma once

#include <span>

#include "core/grid/cell_range.h"
#include "core/scene/state.h"

namespace whorl {

/// Whether an emitter is open during the step that starts at `time`: half a step decides, so that a window of
/// whole steps opens for just as many.
bool is_open(const Emitter& emitter, double time, double dt);

/// The cells whose centres lie in an emitter.
CellRange cells_of(const Emitter& emitter, const Grid& grid);

/// Sets scalars in the fluid cells whose centres lie in open emitters; counts the change of totals as
/// injected. On return the ghosts of scalars are filled.
void apply_emitters(State& state, std::span<const Emitter> emitters, double dt);

}  // namespace whorl
