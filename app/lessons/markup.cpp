#include "app/lessons/markup.h"

namespace whorl::app {
namespace {

constexpr std::string_view blank = " \t\r";
constexpr std::string_view heading = "# ", item = "- ", formula = "    ";

std::string_view trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(blank);
    if (first == line.npos) return {};
    return line.substr(first, line.find_last_not_of(blank) - first + 1);
}

/// The next line, which is taken off the text.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    return line.substr(0, line.find_last_not_of(blank) + 1);
}

}  // namespace

std::vector<Block> blocks_of(std::string_view text) {
    using Kind = Block::Kind;
    std::vector<Block> blocks;
    bool open = false;  // whether the next plain line goes on with the last block
    while (!text.empty()) {
        const std::string_view line = take_line(text);
        if (line.empty()) {
            open = false;
        } else if (line.starts_with(formula)) {
            if (open && blocks.back().kind == Kind::Formula) {
                blocks.back().text += '\n';
            } else {
                blocks.push_back({Kind::Formula, ""});
            }
            blocks.back().text += line.substr(formula.size());
            open = true;
        } else if (line.starts_with(heading)) {
            blocks.push_back({Kind::Heading, std::string(trimmed(line.substr(heading.size())))});
            open = false;
        } else if (line.starts_with(item)) {
            blocks.push_back({Kind::Item, std::string(trimmed(line.substr(item.size())))});
            open = true;
        } else if (open && blocks.back().kind != Kind::Formula) {
            blocks.back().text += ' ';
            blocks.back().text += trimmed(line);
        } else {
            blocks.push_back({Kind::Paragraph, std::string(trimmed(line))});
            open = true;
        }
    }
    return blocks;
}

}  // namespace whorl::app
