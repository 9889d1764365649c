// Emitters: places that hold smoke and heat while they are open.
#pragma once

#include <span>

#include "core/scene/state.h"

namespace whorl {

/// Whether an emitter is open during the step that starts at `time`: half a step decides, so that a window of
/// whole steps opens for just as many.
bool is_open(const Emitter& emitter, double time, double dt);

/// Sets ρ and T in the fluid cells whose centres lie in open emitters; counts the change of ∫ρ as put in.
/// On return the ghosts of ρ and T are filled.
void apply_emitters(State& state, std::span<const Emitter> emitters, double dt);

}  // namespace whorl
