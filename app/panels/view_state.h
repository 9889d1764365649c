// What a person has chosen to look at, apart from the run.
#pragma once

#include <map>

#include "app/panels/colour_range.h"
#include "app/render/colour_map.h"
#include "app/views/views.h"

namespace whorl::app {

/// Whether a view has a field in this snapshot.
inline bool available(const View& view, const Snapshot& snapshot) {
    static thread_local Field scratch;
    return view.field(snapshot, scratch) != nullptr;
}

struct ViewState {
    const View* shown = &views().front();
    std::map<const View*, const ColourMap*> maps;  ///< chosen ones; others have the view's own
    bool crisp = false;                            ///< squares of one value each
    bool arrows = false;                           ///< velocity over the field
    bool help = false;                             ///< the keys are shown
    ColourRange range;

    const ColourMap& map() const {
        const auto chosen = maps.find(shown);
        return chosen != maps.end() ? *chosen->second : *find_colour_map(shown->map);
    }
};

}  // namespace whorl::app
