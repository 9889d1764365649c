// See sheet.h.
#include "app/figure/sheet.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "app/render/field_view.h"
#include "core/io/png.h"

namespace whorl::app {
namespace {

/// Width of a pleasant picture over its height.
constexpr float pleasant = 1.4f;
/// What an empty picture would displease, in stretchings by a factor e.
constexpr float emptiness = 2.0f;

}  // namespace

int columns_for(int fields, glm::ivec2 cells) {
    const float aspect = static_cast<float>(cells.x) / static_cast<float>(std::max(1, cells.y));
    int best = 1;
    float least = INFINITY;
    for (int columns = 1; columns <= fields; ++columns) {
        const int rows = (fields + columns - 1) / columns;
        const auto places = static_cast<float>(rows * columns);
        const float shape = aspect * static_cast<float>(columns) / static_cast<float>(rows);
        const float unused = 1.0f - static_cast<float>(fields) / places;
        const float displeasure = std::abs(std::log(shape / pleasant)) + emptiness * unused;
        if (displeasure < least) {
            least = displeasure;
            best = columns;
        }
    }
    return best;
}

std::vector<SheetRow> arranged(std::vector<SheetCell> cells) {
    glm::ivec2 domain{1, 1};
    for (const SheetCell& cell : cells) {
        if (cell.field != nullptr) domain = domain_of(cell);
    }
    const int columns = columns_for(static_cast<int>(cells.size()), domain);
    std::vector<SheetRow> rows;
    for (SheetCell& cell : cells) {
        if (rows.empty() || std::ssize(rows.back().cells) == columns) rows.emplace_back();
        rows.back().cells.push_back(std::move(cell));
    }
    return rows;
}

glm::ivec2 domain_of(const SheetCell& cell) {
    if (cell.field == nullptr) return {0, 0};
    return domain_of(*cell.field, cell.cells);
}

void check(const SheetRequest& request) {
    const auto demand = [](bool holds, const char* message) {
        if (!holds) throw std::invalid_argument(message);
    };
    demand(request.map != nullptr, "a picture needs a colour map");
    demand(request.scale > 0.0f && request.scale <= largest_sheet_scale,
           "a picture's scale is above 0 and not above 8");
    const float width = request.cell_width * request.scale;
    demand(width >= 1.0f && width <= static_cast<float>(max_image_side),
           "a field in a picture is 1 to 16384 pixels wide");
    bool any = false;
    for (const SheetRow& row : request.rows) {
        for (const SheetCell& cell : row.cells) {
            if (cell.field == nullptr) continue;
            demand(cell.field->width() > 0 && cell.field->height() > 0, "a field in a picture has no cells");
            any = true;
        }
    }
    demand(any, "a picture needs a field");
}

}  // namespace whorl::app
