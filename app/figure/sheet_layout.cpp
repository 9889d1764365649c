// See sheet_layout.h.
#include "app/figure/sheet_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include "app/plot/colour_bar.h"
#include "app/render/text.h"

namespace whorl::app {
namespace {

constexpr float margin_points = 24.0f;
constexpr float narrowest_points = 320.0f;
/// Between fields.
constexpr float gap_points = 12.0f;
/// Narrower columns have no room for a title.
constexpr float narrowest_column = 110.0f;
/// A tall domain is drawn narrower, so that its height stays within this many times the width asked for.
constexpr float tallest = 1.25f;
/// A row of cells is drawn this high.
constexpr float strip_points = 72.0f;
constexpr float narrowest_plot = 280.0f;
constexpr float plot_height = 190.0f;

/// Width and height of all fields, pixels.
ImVec2 field_size(const SheetRequest& request, const Theme& theme) {
    glm::ivec2 domain{0, 0};
    // Squares are equal in a field that is a whole number of them wide, for all resolutions at once.
    float squares = 1.0f;
    float wide = theme.px(request.cell_width);
    for (const SheetRow& row : request.rows) {
        for (const SheetCell& cell : row.cells) {
            const glm::ivec2 cells = domain_of(cell);
            if (cells.x < 1) continue;
            if (domain.x < 1) domain = cells;
            if (squares <= wide) {
                squares =
                    static_cast<float>(std::lcm(static_cast<long>(squares), static_cast<long>(cells.x)));
            }
        }
    }
    const float aspect = static_cast<float>(domain.y) / static_cast<float>(domain.x);
    if (aspect > tallest) wide = wide * tallest / aspect;
    if (request.crisp && wide >= 2.0f * squares) wide = std::floor(wide / squares) * squares;
    wide = std::max(1.0f, std::round(wide));
    return {wide, domain.y == 1 ? theme.px(strip_points) : std::max(1.0f, std::round(wide * aspect))};
}

/// A row's label, a line a part.
std::vector<std::string> lines_of(std::string_view label) {
    constexpr std::string_view between = " · ";
    std::vector<std::string> lines;
    while (!label.empty()) {
        const std::size_t end = std::min(label.find(between), label.size());
        lines.emplace_back(label.substr(0, end));
        label.remove_prefix(std::min(label.size(), end + between.size()));
    }
    return lines;
}

bool has_head(const SheetCell& cell) {
    return !cell.title.empty() || !cell.note.empty();
}

/// Whether a cell's title and note are to be drawn: they are not where the cell above has the same.
bool shows_head(const SheetRequest& request, std::size_t row, std::size_t column) {
    const SheetCell& cell = request.rows[row].cells[column];
    if (row == 0 || column >= request.rows[row - 1].cells.size()) return has_head(cell);
    const SheetCell& above = request.rows[row - 1].cells[column];
    return has_head(cell) &&
           (cell.title != above.title || cell.note != above.note || cell.colour != above.colour);
}

class Layouter {
  public:
    Layouter(const SheetRequest& request, const Theme& theme)
        : request_(request), theme_(theme), size_(field_size(request, theme)) {}

    SheetLayout run() {
        place_columns();
        y_ = theme_.px(margin_points);
        layout_.title_y = y_;
        if (!request_.title.empty()) {
            y_ += paragraph_height(*theme_.title, request_.title, layout_.text_width) + theme_.px(14.0f);
        }
        for (std::size_t row = 0; row < request_.rows.size(); ++row) place_row(row);
        place_bar();
        if (!request_.plots.empty()) place_plots();
        if (!request_.caption.empty()) {
            y_ += theme_.px(16.0f);
            layout_.caption_y = y_;
            y_ += paragraph_height(*theme_.small, request_.caption, layout_.text_width);
        }
        layout_.height = static_cast<int>(std::ceil(y_ + theme_.px(margin_points - 4.0f)));
        return std::move(layout_);
    }

  private:
    void place_columns() {
        std::size_t columns = 0;
        float labels = 0.0f;
        for (const SheetRow& row : request_.rows) {
            columns = std::max(columns, row.cells.size());
            for (const std::string& line : lines_of(row.label)) {
                labels = std::max(labels, std::ceil(text_width(*theme_.body, line)));
            }
        }
        if (labels > 0.0f) labels += theme_.px(14.0f);
        column_ = columns > 1 ? std::max(size_.x, theme_.px(narrowest_column)) : size_.x;
        const auto count = static_cast<float>(columns);
        const float fields = count * column_ + (count - 1.0f) * theme_.px(gap_points);
        const float narrowest = theme_.px(narrowest_points);
        layout_.left = theme_.px(margin_points);
        layout_.text_width = std::max(labels + fields, narrowest);
        layout_.width = static_cast<int>(layout_.text_width + 2.0f * layout_.left);
        fields_left_ = layout_.left + labels + std::floor(0.5f * (layout_.text_width - labels - fields));
        const bool narrow = fields < narrowest;
        layout_.bar.x = narrow ? layout_.left : fields_left_;
        layout_.bar_width = narrow ? layout_.text_width : fields - (column_ - size_.x);
    }

    void place_row(std::size_t row) {
        const std::vector<SheetCell>& cells = request_.rows[row].cells;
        float titles = 0.0f;
        float notes = 0.0f;
        bool heads = false;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            if (!shows_head(request_, row, k)) continue;
            heads = true;
            const float swatch = cells[k].colour < 0 ? 0.0f : swatch_space(theme_);
            titles = std::max(titles, paragraph_height(*theme_.bold, cells[k].title, column_ - swatch));
            notes = std::max(notes, paragraph_height(*theme_.small, cells[k].note, column_));
        }
        if (row > 0) y_ += theme_.px(heads ? 20.0f : gap_points);
        const float title_y = y_;
        const float note_y = y_ + titles + theme_.px(titles > 0.0f ? 4.0f : 0.0f);
        if (heads) y_ = (notes > 0.0f ? note_y + notes : y_ + titles) + theme_.px(8.0f);

        for (std::size_t k = 0; k < cells.size(); ++k) {
            const float x = fields_left_ + static_cast<float>(k) * (column_ + theme_.px(gap_points));
            SheetLayout::Cell place{&cells[k],
                                    {static_cast<int>(x), static_cast<int>(y_), static_cast<int>(size_.x),
                                     static_cast<int>(size_.y)},
                                    {}};
            if (shows_head(request_, row, k)) place.head = {{x, title_y}, note_y, column_};
            layout_.cells.push_back(place);
        }
        place_label(request_.rows[row].label);
        y_ += size_.y;
    }

    void place_label(const std::string& label) {
        const std::vector<std::string> lines = lines_of(label);
        const float step = std::round(1.3f * theme_.body->FontSize);
        float y = std::round(y_ + 0.5f * (size_.y - step * static_cast<float>(lines.size())));
        for (std::size_t k = 0; k < lines.size(); ++k, y += step) {
            layout_.labels.push_back({lines[k], {layout_.left, y}, k == 0});
        }
    }

    void place_bar() {
        y_ += theme_.px(18.0f);
        layout_.bar.y = y_;
        y_ += colour_bar_height(theme_, {*request_.map, request_.lo, request_.hi, request_.label});
    }

    void place_plots() {
        y_ += theme_.px(20.0f);
        const float gap = theme_.px(gap_points);
        const std::size_t count = request_.plots.size();
        const auto most = static_cast<std::size_t>(
            std::max(1.0f, (layout_.text_width + gap) / (theme_.px(narrowest_plot) + gap)));
        const std::size_t rows = (count + most - 1) / most;
        const std::size_t columns = (count + rows - 1) / rows;
        const float wide = std::floor((layout_.text_width + gap) / static_cast<float>(columns) - gap);
        const float high = theme_.px(plot_height);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t row = k / columns;
            const ImVec2 corner{layout_.left + static_cast<float>(k % columns) * (wide + gap),
                                y_ + static_cast<float>(row) * (high + gap)};
            layout_.plots.push_back({&request_.plots[k], corner, {wide, high}});
        }
        y_ += static_cast<float>(rows) * (high + gap) - gap;
    }

    const SheetRequest& request_;
    const Theme& theme_;
    ImVec2 size_;  ///< of a field
    float column_ = 0.0f;
    float fields_left_ = 0.0f;
    float y_ = 0.0f;
    SheetLayout layout_;
};

}  // namespace

float swatch_side(const Theme& theme) {
    return theme.px(9.0f);
}

float swatch_space(const Theme& theme) {
    return swatch_side(theme) + theme.px(7.0f);
}

SheetLayout lay_out(const SheetRequest& request, const Theme& theme) {
    return Layouter(request, theme).run();
}

}  // namespace whorl::app
