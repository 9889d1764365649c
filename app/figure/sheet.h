// What a picture shows: fields in rows and columns, one colour bar for all, and plots.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/render/colour_map.h"
#include "app/render/view_window.h"
#include "core/grid/field.h"

namespace whorl::app {

/// A field on a sheet. What it points to must live until it is drawn.
struct SheetCell {
    const Field* field = nullptr;               ///< null leaves the place empty
    std::span<const std::uint8_t> solids = {};  ///< nx × ny, non-zero is solid; empty for none
    const FaceVelocity* arrows = nullptr;       ///< velocity to draw over the field
    glm::ivec2 cells{0, 0};                     ///< size of the domain; 0 takes the field's own shape
    std::string title = {};
    std::string note = {};     ///< what differs, under the title
    int colour = -1;           ///< lane whose colour goes before the title; none if negative
    std::string stopped = {};  ///< why there is nothing newer, over the field
};

struct SheetRow {
    std::string label = {};  ///< at the left, broken at " · "; no room is left if no row has any
    std::vector<SheetCell> cells;
};

struct SheetCurve {
    std::string label;
    int colour = -1;       ///< lane; grey if negative
    std::vector<float> x;  ///< ascending
    std::vector<float> y;  ///< as many
};

/// A plot beneath the fields.
struct SheetPlot {
    std::string title;
    std::string unit = {};
    std::string x_name = "step";
    std::string x_unit = {};
    bool log_x = false;
    bool log_y = false;
    std::vector<SheetCurve> curves;
};

/// Beyond this, the texture of the letters alone takes more than a hundred megabytes.
inline constexpr float largest_sheet_scale = 8.0f;

/// A whole picture. All domains have the same shape and are drawn in the same size, whatever their
/// resolutions. Titles and notes stand above a cell unless the cell above says the same: once for a column of
/// one lane.
struct SheetRequest {
    std::vector<SheetRow> rows;
    const ColourMap* map = nullptr;
    float lo = 0.0f;            ///< value at the map's start, the fields' unit
    float hi = 1.0f;            ///< value at the map's end
    std::string title = {};     ///< wrapped if it is long
    std::string label = {};     ///< quantity and unit, at the colour bar
    bool below = false;         ///< names the colour of values below 0
    std::string caption = {};   ///< schemes, step, time …; lines are wrapped
    ViewWindow window{};        ///< part of every domain that is shown
    bool crisp = false;         ///< squares of one value each
    bool light = false;         ///< dark on white, for paper
    float scale = 1.0f;         ///< pixels to a point, up to the largest: everything grows with it
    float cell_width = 900.0f;  ///< of a field, about, points
    std::vector<SheetPlot> plots = {};
};

/// Columns in which so many fields of that domain make a picture of pleasant shape: a row of two or three
/// squares, 2 × 2, 3 × 2; a stack of wide ones, a row of tall ones.
int columns_for(int fields, glm::ivec2 cells);

/// The cells in rows, `columns_for` each.
std::vector<SheetRow> arranged(std::vector<SheetCell> cells);

/// Size of the domain that a cell shows, cells; 0 × 0 if it is empty.
glm::ivec2 domain_of(const SheetCell& cell);

/// @throws std::invalid_argument with one line that says what is wrong: nothing to draw, an empty field, no
///         map, or sizes that are no sizes.
void check(const SheetRequest& request);

}  // namespace whorl::app
