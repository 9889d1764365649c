#include "core/io/toml_text.h"

#include "core/base/error.h"

namespace whorl {
namespace {

/// Tables in tables by the dots of one key. The library bounds how deep values nest (256), but not this, and
/// it visits tables by recursion: a line of dots would exhaust the stack.
constexpr int max_dots = 32;
constexpr std::size_t max_reason = 400;  // of an error, bytes

/// Refuses keys of more than `max_dots` dots. Texts are not told from keys: in one, as in a key, so many dots
/// count only if they are apart from each other and no comma, bracket, equals sign or new line is among them.
void check_dots(std::string_view text, std::string_view name) {
    toml::source_position at{1, 1};
    int dots = 0;
    char before = '\0';
    for (const char c : text) {
        if (c == '.' && before != '.' && ++dots > max_dots) fail_at(name, at, "too many dots in a key");
        if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots = 0;
        at.column = c == '\n' ? 1 : at.column + 1;
        at.line += c == '\n' ? 1 : 0;
        before = c;
    }
}

struct Phrase {
    std::string_view theirs, ours;
};

/// What the library says without a word of what would be right.
constexpr Phrase phrases[] = {
    {"unescaped control characters",
     R"(a text ends in the line that it begins in: close it with ", or write it between """ and """)"},
    {"string: encountered end-of-file", R"(a text is not closed: """ is missing)"},
    {"array: encountered end-of-file", "a list is not closed: ] is missing"},
    {"could not determine value type", R"(this is no value; a text stands in "quotes")"},
};

std::string plain_words(std::string_view reason) {
    for (const Phrase& p : phrases) {
        if (reason.find(p.theirs) != std::string_view::npos) return std::string(p.ours);
    }
    return std::string(reason);
}

}  // namespace

void fail_at(std::string_view name, const toml::source_position& at, std::string_view reason) {
    std::string line(reason.substr(0, max_reason));
    if (line.size() < reason.size()) {
        // Not within a character of several bytes.
        while ((reason[line.size()] & 0xc0) == 0x80) line.pop_back();
        line += " …";
    }
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    }
    throw InputError(std::string(name) + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) +
                     ": " + line);
}

toml::table parse_toml(std::string_view text, std::string_view name, std::size_t max_bytes) {
    if (text.size() > max_bytes)
        fail_at(name, {1, 1}, "too long: over " + std::to_string(max_bytes >> 20) + " MiB");
    check_dots(text, name);
    try {
        return toml::parse(text, name);
    } catch (const toml::parse_error& e) {
        fail_at(name, e.source().begin, plain_words(e.description()));
    }
}

}  // namespace whorl
