#include "core/base/suggest.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace whorl {
namespace {

/// Levenshtein's distance, with a word that begins or contains the other taken as near.
std::size_t distance(std::string_view a, std::string_view b) {
    if (!a.empty() && b.find(a) != std::string_view::npos) return 1;
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
            diagonal = above;
        }
    }
    return row.back();
}

/// `a, b or c`
std::string listed(std::span<const std::string_view> words) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (k > 0) text += k + 1 == words.size() ? " or " : ", ";
        text += words[k];
    }
    return text;
}

/// Whether so many edits are a slip, not another word.
bool is_slip(std::size_t edits, std::string_view word) {
    return edits < word.size() && edits <= std::max<std::size_t>(2, word.size() / 2);
}

}  // namespace

std::string suggestion(std::string_view word, std::span<const std::string_view> candidates) {
    constexpr std::size_t most = 3;
    constexpr std::size_t longest = 64;        // no word of ours is; the time grows with each letter
    constexpr std::size_t longest_list = 400;  // letters
    word = word.substr(0, longest);
    std::vector<std::string_view> nearest(candidates.begin(), candidates.end());
    std::stable_sort(nearest.begin(), nearest.end(), [&](std::string_view a, std::string_view b) {
        return distance(word, a) < distance(word, b);
    });
    if (nearest.empty()) return "there is none";
    if (!is_slip(distance(word, nearest.front()), word)) {
        const std::string all = listed(candidates);
        if (all.size() <= longest_list) return "give " + all;
    }
    if (nearest.size() > most) nearest.resize(most);
    // What is much farther off than the best is no help.
    while (nearest.size() > 1 && distance(word, nearest.back()) > distance(word, nearest.front()) + 1)
        nearest.pop_back();
    return "did you mean " + listed(nearest) + "?";
}

}  // namespace whorl
