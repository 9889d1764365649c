// Requests for sheets of plain lanes.
#pragma once

#include <string>
#include <vector>

#include "app/figure/sheet.h"

namespace whorl::app {

inline SheetRequest request_of(std::vector<SheetRow> rows) {
    SheetRequest request;
    request.rows = std::move(rows);
    request.map = find_colour_map("white-black");
    request.cell_width = 200;
    return request;
}

inline SheetCell lane(const Field& field, int k) {
    SheetCell cell;
    cell.field = &field;
    cell.title = "lane " + std::to_string(k);
    cell.note = "what differs";
    cell.colour = k;
    return cell;
}

}  // namespace whorl::app
