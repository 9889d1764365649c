#include "app/ui/tiles.h"

#include <algorithm>
#include <cmath>

namespace whorl::app {

Tiles largest_tiles(int count, float aspect, float width, float height, float gap, float head) {
    Tiles best;
    // From many columns to few: where two are equally large, fewer columns leave fewer places empty.
    for (int columns = count; columns >= 1; --columns) {
        const int rows = (count + columns - 1) / columns;
        const float wide = (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
        const float high = height / static_cast<float>(rows) - head;
        const float field = std::floor(std::min(wide, high / aspect));
        if (field < best.width) continue;
        best = {columns, rows, field, std::floor(field * aspect)};
    }
    best.width = std::max(1.0f, best.width);
    best.height = std::max(1.0f, best.height);
    return best;
}

}  // namespace whorl::app
