// The valid words nearest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace whorl {

/// `did you mean x or y?` with the candidates nearest to `word` by edits; `give x, y or z` with all of them
/// where none is near and they fit on a line.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace whorl
