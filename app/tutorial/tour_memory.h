// Remembers, from one start to the next, that the tour was taken.
#pragma once

#include <filesystem>

namespace whorl::app {

/// An empty file that is there once the tour was taken: whorl/tour-seen below $XDG_STATE_HOME, or below
/// ~/.local/state where that is not set. Empty if there is no home either.
std::filesystem::path tour_memory();

bool tour_seen();

/// @throws std::runtime_error if the file cannot be written
void remember_tour();

}  // namespace whorl::app
