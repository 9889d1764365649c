// Where everything on a sheet goes.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "app/figure/sheet.h"
#include "app/render/field_view.h"
#include "app/render/theme.h"

namespace whorl::app {

/// All in pixels from the picture's top left.
struct SheetLayout {
    /// A cell's title and note.
    struct Head {
        ImVec2 title;  ///< of the swatch, if there is one, before the title
        float note_y;
        float width;
    };
    struct Cell {
        const SheetCell* cell;
        PixelRect field;
        std::optional<Head> head;
    };
    /// A line of a row's label.
    struct LabelLine {
        std::string text;
        ImVec2 at;
        bool first;  ///< the one that is read first
    };
    struct PlotPlace {
        const SheetPlot* plot;
        ImVec2 corner;
        ImVec2 size;
    };

    int width = 0;
    int height = 0;
    float left = 0.0f;        ///< of title, plots and caption
    float text_width = 0.0f;  ///< of the same
    float title_y = 0.0f;
    ImVec2 bar;
    float bar_width = 0.0f;
    float caption_y = 0.0f;
    std::vector<Cell> cells;
    std::vector<LabelLine> labels;
    std::vector<PlotPlace> plots;
};

/// Room between a swatch's left end and the title behind it, pixels; its side is `swatch_side`.
float swatch_space(const Theme& theme);
float swatch_side(const Theme& theme);

/// @pre check(request) has passed
SheetLayout lay_out(const SheetRequest& request, const Theme& theme);

}  // namespace whorl::app
