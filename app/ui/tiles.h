// ControlRects for several fields of one shape, as large as they get.
#pragma once

namespace whorl::app {

/// Equal places in rows, filled from the upper left.
struct Tiles {
    int columns = 1, rows = 1;
    float width = 0, height = 0;  ///< of one field, whole pixels, 1 at least
};

/// The arrangement that gives the largest fields; of equal ones the one with the fewest empty places.
/// @param count   1 at least
/// @param aspect  height by width of a field
/// @param width   room for all, pixels
/// @param height  room for all, pixels
/// @param gap     between columns, pixels
/// @param head    above every field, pixels
Tiles largest_tiles(int count, float aspect, float width, float height, float gap, float head);

}  // namespace whorl::app
