// What a run starts from: setups of which the flow, the exact solution or both may be known. One table.
#pragma once

#include <span>
#include <string_view>

#include "core/scene/state.h"

namespace whorl {

/// A setup. Null functions mean: the air starts still and clear, the solver finds the flow, no exact
/// solution.
struct Experiment {
    SchemeInfo info;
    /// Sets the domain, times and forces that the experiment is known by.
    void (*setup)(Scene&);
    /// Writes the initial fields; ghosts are filled afterwards.
    void (*start)(State&);
    /// Writes the prescribed velocity at a time; ghosts are filled afterwards. With it nothing is solved, and
    /// only the density is advected.
    void (*flow)(double time, const Grid&, FaceVelocity&);
    /// Writes the exact density at a time. @return false where it is not known
    bool (*exact)(double time, double dt, const Grid&, Field& density);
    /// When the exact density is known, in words; empty where it never is.
    std::string_view known = {};
    /// Whether it is a test to be measured and compared, not only a place to begin.
    bool listed = true;
};

/// All experiments; the first is `empty`.
std::span<const Experiment> experiments();

/// @throws InputError that names the nearest keys
const Experiment& experiment(std::string_view key);

/// The scene that an experiment is known by.
Scene scene_of(const Experiment& experiment);

}  // namespace whorl
