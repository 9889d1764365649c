// See csv.h.
#include "core/base/csv.h"

#include <cmath>

#include "core/base/number.h"

namespace whorl {

std::string csv_text(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string csv_number(double value, int digits) {
    return std::isfinite(value) ? significant(value, digits) : std::string();
}

}  // namespace whorl
