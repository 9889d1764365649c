#include "app/panels/colour_range.h"

#include <algorithm>
#include <cmath>

namespace whorl::app {
namespace {

// A field that grows is followed at once, so that little saturates; one that fades is let go slowly.
constexpr double rise_seconds = 0.1;
constexpr double fall_seconds = 2.5;
// Below this share of the usual range a field counts as empty and keeps the range it had.
constexpr float empty_share = 1e-4f;

float farthest(const Field& field, float neutral) {
    float reach = 0;
    for (int j = 0; j < field.height(); ++j) {
        const Real* row = field.row(j);
        for (int i = 0; i < field.width(); ++i) {
            reach = std::max(reach, std::abs(static_cast<float>(row[i]) - neutral));
        }
    }
    return reach;
}

}  // namespace

void ColourRange::set(float lo, float hi) {
    if (!(lo < hi) || !std::isfinite(lo) || !std::isfinite(hi)) return;
    lo_ = lo;
    hi_ = hi;
    held_ = true;
}

void ColourRange::follow(const Quantity& quantity, const Field& field, double ambient, double seconds) {
    const bool another = quantity_ != &quantity;
    quantity_ = &quantity;
    if (another) held_ = false;
    if (held_) return;
    const float neutral =
        quantity.scale == Quantity::Scale::AboutAmbient ? static_cast<float>(ambient) : 0.0f;
    float wanted = farthest(field, neutral);
    if (!std::isfinite(wanted) || wanted < empty_share * quantity.usual) {
        wanted = another ? quantity.usual : reach_;
    }
    const double pace = wanted > reach_ ? rise_seconds : fall_seconds;
    const float share = another ? 1.0f : static_cast<float>(1.0 - std::exp(-seconds / pace));
    reach_ += share * (wanted - reach_);
    lo_ = quantity.diverging() ? neutral - reach_ : 0.0f;
    hi_ = neutral + reach_;
}

}  // namespace whorl::app
