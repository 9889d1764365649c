// The markup of lessons' texts: headings, paragraphs, items and formulas, and nothing else.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace whorl::app {

/// A piece of a text that is laid out by itself.
struct Block {
    enum class Kind { Paragraph, Heading, Item, Formula };
    Kind kind;
    std::string text;  ///< one line, to be wrapped; a formula has a line each, not to be wrapped
    bool operator==(const Block&) const = default;
};

/// Splits a text into its blocks:
/// - `# ` begins a heading, of one line;
/// - `- ` begins an item, which goes on to the next block;
/// - four spaces begin a line of a formula, which keeps further ones;
/// - other lines, up to an empty one or to one of these, are a paragraph.
std::vector<Block> blocks_of(std::string_view text);

}  // namespace whorl::app
