#include "core/pressure/modes.h"

#include <cmath>
#include <numbers>

namespace whorl {
namespace {

enum class Wave { Cosine, Sine };

/// Mode of `half_turns` half waves over n cells, as far as cell `count` − 1, scaled to length 1 over all n.
void add_mode(ModeSet& set, int n, Wave wave, int half_turns) {
    const int k = static_cast<int>(set.eigenvalues.size());
    const auto value = [&](int i) {
        // (2i + 1) half_turns mod 4n quarter steps: exact for any n, where a large angle would lose digits
        const long long steps = (2LL * i + 1) * half_turns % (4LL * n);
        const double angle = std::numbers::pi * static_cast<double>(steps) / (2.0 * n);
        return wave == Wave::Cosine ? std::cos(angle) : std::sin(angle);
    };
    double square = 0;
    for (int i = 0; i < n; ++i) square += value(i) * value(i);
    for (int i = 0; i < set.count; ++i)
        set.values[static_cast<std::size_t>(i) * set.count + k] = value(i) / std::sqrt(square);
    const double s = std::sin(std::numbers::pi * half_turns / (2.0 * n));
    set.eigenvalues.push_back(4 * s * s);  // 2 − 2 cos(π half_turns / n)
}

}  // namespace

Modes modes(int n, bool periodic) {
    Modes all;
    all.even.count = (n + 1) / 2;
    all.odd.count = n / 2;
    for (ModeSet* set : {&all.even, &all.odd})
        set->values.assign(static_cast<std::size_t>(set->count) * set->count, 0);
    for (int k = 0; k < all.even.count; ++k) add_mode(all.even, n, Wave::Cosine, 2 * k);
    for (int k = 0; k < all.odd.count; ++k) {
        if (periodic) {
            add_mode(all.odd, n, Wave::Sine, 2 * (k + 1));
        } else {
            add_mode(all.odd, n, Wave::Cosine, 2 * k + 1);
        }
    }
    return all;
}

}  // namespace whorl
