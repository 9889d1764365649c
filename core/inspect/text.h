// An explanation as plain text.
#pragma once

#include <string>

#include "core/inspect/explanation.h"

namespace whorl {

/// Lines of UTF-8: the paths along the flow, then every sum with its terms, indented under what it is part
/// of.
std::string write_text(const Explanation& explanation);

}  // namespace whorl
