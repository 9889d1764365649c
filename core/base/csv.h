// Fields of a CSV table.
#pragma once

#include <string>
#include <string_view>

namespace whorl {

/// A text: in quotes where it holds what ends a field.
std::string csv_text(std::string_view text);

/// A number: nothing where it is not finite. Nine digits give a float back exactly.
std::string csv_number(double value, int digits = 9);

}  // namespace whorl
