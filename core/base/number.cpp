// See number.h.
#include "core/base/number.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace whorl {
namespace {

std::string print(const char* format, int digits, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, digits, value);
    return text;
}

std::string spelt(double value, const char* format, int digits) {
    if (std::isnan(value)) return "NaN";
    if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
    if (value == 0.0) return "0";
    std::string text = short_exponent(print(format, digits, value));
    if (text.back() == '.') text.pop_back();
    if (text.front() == '-') text = "−" + text.substr(1);
    return text;
}

}  // namespace

std::string shortest(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string significant(double value, int digits) {
    return print("%.*g", digits, value + 0.0);  // + 0.0: no "-0"
}

std::string figure(double value, int digits) {
    return spelt(value, "%.*g", digits);
}

std::string reading(double value) {
    return spelt(value, "%#.*g", 4);
}

std::string short_exponent(std::string text) {
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    std::size_t digits = e + 1;
    if (text[digits] == '+') {
        text.erase(digits, 1);
    } else {
        ++digits;
    }
    while (digits + 1 < text.size() && text[digits] == '0') text.erase(digits, 1);
    return text;
}

}  // namespace whorl
