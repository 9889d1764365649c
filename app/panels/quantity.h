// The views: which quantity of a snapshot is on screen. One table.
#pragma once

#include <span>
#include <string_view>

#include "core/session/snapshot.h"

namespace whorl::app {

/// A quantity that can be looked at.
struct Quantity {
    /// Where the colour map's neutral value lies.
    enum class Scale {
        FromZero,      ///< sequential, from 0 up
        AboutZero,     ///< diverging, symmetric about 0
        AboutAmbient,  ///< diverging, symmetric about the scene's ambient temperature
    };

    std::string_view key;
    std::string_view label;
    std::string_view unit;
    std::string_view help;
    Scale scale;
    float usual;       ///< range on either side of the neutral value before there is anything to see
    bool needs_exact;  ///< only where an exact solution is known
    /// The field itself, or one worked out in `scratch`.
    const Field& (*field)(const Snapshot&, Field& scratch);

    bool diverging() const { return scale != Scale::FromZero; }
    bool available(const Snapshot& s) const { return !needs_exact || s.has_exact; }
};

/// All quantities; the first is the default.
std::span<const Quantity> quantities();

}  // namespace whorl::app
