#include "core/schemes/suggest.h"

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

}  // namespace

std::string suggestion(std::string_view word, std::span<const std::string_view> candidates) {
    constexpr std::size_t most = 3;
    constexpr std::size_t longest = 64;  // no word of ours is; the time grows with each letter
    word = word.substr(0, longest);
    std::vector<std::string_view> nearest(candidates.begin(), candidates.end());
    std::stable_sort(nearest.begin(), nearest.end(), [&](std::string_view a, std::string_view b) {
        return distance(word, a) < distance(word, b);
    });
    if (nearest.size() > most) nearest.resize(most);
    // What is much farther off than the best is no help.
    while (nearest.size() > 1 && distance(word, nearest.back()) > distance(word, nearest.front()) + 1)
        nearest.pop_back();
    std::string text = "did you mean ";
    for (std::size_t k = 0; k < nearest.size(); ++k) {
        if (k > 0) text += k + 1 == nearest.size() ? " or " : ", ";
        text += nearest[k];
    }
    return text + "?";
}

}  // namespace whorl
