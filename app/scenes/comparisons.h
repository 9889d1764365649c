// The comparisons that come with the program: lanes for any scene.
#pragma once

#include <span>
#include <string_view>

#include "core/io/run_file.h"

namespace whorl::app {

/// A file of app/scenes/comparisons, embedded.
struct Comparison {
    std::string_view key;   ///< the file's name
    std::string_view text;  ///< TOML
    Lanes lanes() const;
};

/// All comparisons, the one that shows most first.
std::span<const Comparison> comparisons();

/// The lanes called `name`: a comparison, or where the name ends in .toml or .png or has a slash, those of a
/// file.
/// @throws InputError that names the nearest keys, or what is wrong in the file
Lanes find_lanes(std::string_view name);

}  // namespace whorl::app
