// TOML that may come from anywhere: parsed in bounded time and memory, errors on one line.
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace whorl {

/// Parses a text.
/// @param name  what errors call it
/// @param max_bytes  length beyond which it is refused. A megabyte of the worst text takes a second, and the
/// time
///                   grows with the square: long lists belong into arrays, not into tables.
/// @throws InputError `name:line:column: reason`
toml::table parse_toml(std::string_view text, std::string_view name, std::size_t max_bytes);

/// @throws InputError `name:line:column: reason`; what the reason quotes of a text is cut and made printable
[[noreturn]] void fail_at(std::string_view name, const toml::source_position& at, std::string_view reason);

}  // namespace whorl
