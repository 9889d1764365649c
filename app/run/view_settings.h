// What a person has chosen to look at, apart from the run.
#pragma once

#include <map>

#include "app/render/colour_map.h"
#include "app/render/view_window.h"
#include "app/run/colour_range.h"
#include "app/views/views.h"

namespace whorl::app {

/// Whether a view has a field in this snapshot.
inline bool available(const View& view, const Snapshot& snapshot) {
    static thread_local Field scratch;
    return view.field(snapshot, scratch) != nullptr;
}

/// How several lanes share the field's place.
enum class Compare { SideBySide, One, Wipe };

struct ViewSettings {
    const View* shown = views().front();
    bool difference = false;  ///< of each lane from the reference lane, in that view
    Compare compare = Compare::SideBySide;
    bool peek = false;    ///< where one lane is shown: the other one in its place
    float wipe = 0.5f;    ///< where one lane ends and the other begins, part of the field's width
    ViewWindow window{};  ///< part of the domain that is shown, of all lanes
    std::map<const View*, const ColourMap*> maps;  ///< chosen ones; others have the view's own
    bool crisp = false;                            ///< squares of one value each
    bool arrows = false;                           ///< velocity over the field
    bool count_limited = false;                    ///< the nodes that limiters change, beside the measures
    ColourRange range;

    /// The colours of a view, or of differences in it, which all have the same.
    const ColourMap& map(const View& of, bool of_difference) const {
        const View& view = coloured(of, of_difference);
        const auto chosen = maps.find(&view);
        return chosen != maps.end() ? *chosen->second : *find_colour_map(view.map);
    }
    const ColourMap& map() const { return map(*shown, difference); }
    /// Whether the nodes that limiters change are counted: for the chosen view, or beside the measures.
    bool counts_limited() const { return count_limited || shown->of_limiters; }
    void choose(const ColourMap& map) { maps[&coloured(*shown, difference)] = &map; }

  private:
    static const View& coloured(const View& of, bool of_difference) {
        return of_difference ? app::view("difference") : of;
    }
};

}  // namespace whorl::app
