// What an entry of a list is called.
#pragma once

#include <string>
#include <string_view>

namespace whorl {

/// How a scheme is called in files (`key`), on screen (`label`) and in the literature (`source`), and what it
/// does in a sentence (`help`).
struct SchemeInfo {
    std::string_view key;
    std::string_view label;
    std::string_view source;
    std::string_view help;
};

/// The last of a scheme's sources: where the thesis has it, if it does.
std::string thesis_part(std::string_view source);

}  // namespace whorl
