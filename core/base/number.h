// Numbers as text.
#pragma once

#include <string>

namespace whorl {

/// As many digits as give the number back exactly.
std::string shortest(double value);

/// `digits` significant digits at most, as printf's %g; zero has no sign.
std::string significant(double value, int digits);

/// A value to be read: `digits` significant digits without trailing zeros, a real minus sign, "not a number"
/// spelt "NaN".
std::string figure(double value, int digits = 4);

/// A value that changes while it is read: always four significant digits, so that it keeps its width.
std::string reading(double value);

/// 1e+05 as 1e5, 1e-05 as 1e-5.
std::string short_exponent(std::string text);

}  // namespace whorl
