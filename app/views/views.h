// What of a snapshot can be looked at: one table for the window, the command line and the pictures.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/session/snapshot.h"

namespace whorl::app {

/// Values at the two ends of a colour bar.
struct Range {
    float lo, hi;
};

/// A quantity to look at.
struct View : FieldDisplay {
    std::string_view key;
    /// The field, computed into `scratch` where the snapshot does not hold it; null where there is none.
    std::function<const Field*(const Snapshot&, Field& scratch)> field;
    bool of_limiters = false;  ///< counts: drawn crisp; 0 unless limiters are watched, see Watch

    /// Whether colours go to either side of a middle, and do not grow from 0.
    bool diverges() const { return middle != FieldDisplay::Middle::None; }
    /// The middle, or 0.
    float centre(const Snapshot& snapshot) const;
    /// What fluid cells span, the middle among it, or 0 where there is none.
    Range extent(const Snapshot& snapshot, const Field& values) const;
    /// The same as colours show it: from 0, or as far to either side of the middle.
    Range shown(const Snapshot& snapshot, Range extent) const;
    /// The range that shows all of the field's fluid cells: from 0, or symmetric about the middle.
    Range automatic_range(const Snapshot& snapshot, const Field& values) const;
};

/// Whether the flow is solved for, not given.
bool is_solved(const Snapshot& lane);

/// All views, in the order of menus: of the fields that a run carries, of derived ones, and of what only a
/// snapshot knows. The first is the default.
std::span<const View* const> views();

/// Adds one, before the first window or picture.  @throws InputError if its key is taken
void add_view(const View& view);

/// @throws InputError that names the nearest keys
const View& view(std::string_view key);

/// A snapshot of the present state with all that a view shows.
void take_shown(Session& session, const View& view, const SessionSnapshot& last, Pool& pool,
                SessionSnapshot& out);

/// A scheme set in the words of the thesis: "MacCormack · linear · midpoint".
std::string describe(const SchemeSet& schemes);
/// The same of a scene's two sets, a line each where they differ.
std::string describe(const Scene& scene);

/// The caption of a picture: schemes, resolution, Δt, step and time.
std::string caption(const Snapshot& snapshot);

/// What stands at the colour bar of a picture: the quantity and its unit.
std::string bar_label(const View& view);

}  // namespace whorl::app
