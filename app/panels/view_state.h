// What a person has chosen to look at, apart from the run.
#pragma once

#include <optional>
#include <string>

#include "app/panels/colour_range.h"
#include "app/panels/quantity.h"
#include "app/render/colour_map.h"

namespace whorl::app {

struct ViewState {
    const Quantity* quantity = &quantities().front();
    std::string sequential_map = "magma";
    std::string diverging_map = "blue-dark-red";
    bool crisp = false;   ///< squares of one value each
    bool arrows = false;  ///< velocity over the field
    bool help = false;    ///< the keys are shown
    ColourRange range;
    std::optional<double> marker;  ///< x of the plot sample under the pointer, a hairline in the others

    const ColourMap& map() const {
        const ColourMap* found = find_colour_map(quantity->diverging() ? diverging_map : sequential_map);
        return found != nullptr ? *found : colour_maps().front();
    }
};

}  // namespace whorl::app
