// See card.h.
#include "app/plot/card.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/render/text.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

constexpr float pad_points = 9.0f;
/// A frame lower than this shows nothing; a legend that would leave less gives way.
constexpr float lowest_frame = 24.0f;
constexpr float lowest_frame_with_legend = 44.0f;
/// The axis' name takes at most this part of it.
constexpr float longest_name = 0.5f;

/// The names of a legend, cut to the card's width and broken into lines.
class Legend {
  public:
    Legend(const Theme& theme, std::span<const LegendEntry> entries, float room)
        : theme_(theme), entries_(entries), room_(room) {
        const float longest = room - dash() - gap();
        for (const LegendEntry& entry : entries) names_.push_back(fitted(*theme.small, entry.label, longest));
    }

    /// Width on one line.
    float width() const {
        float sum = -apart();
        for (std::size_t k = 0; k < names_.size(); ++k) sum += width_of(k) + apart();
        return sum;
    }
    /// Height where it is wrapped, 0 if it is empty.
    float height() const {
        float last = 0.0f;
        if (names_.empty()) return last;
        for_each([&](std::size_t, float, float y) { last = y; });
        return last + theme_.small->FontSize;
    }
    void draw(ImDrawList& list, ImVec2 corner) const {
        const ImFont& small = *theme_.small;
        for_each([&](std::size_t k, float x, float y) {
            const ImVec2 at{std::floor(corner.x + x), std::floor(corner.y + y)};
            const float middle = at.y + std::floor(0.55f * small.FontSize);
            const float half = theme_.px(entries_[k].area ? 4.0f : 1.0f);
            const float wide = entries_[k].area ? 2.0f * half : dash();
            list.AddRectFilled({at.x + dash() - wide, middle - half}, {at.x + dash(), middle + half},
                               entries_[k].colour, entries_[k].area ? theme_.px(1.5f) : 0.0f);
            add_text(list, small, {at.x + dash() + gap(), at.y}, theme_.palette.text_dim, names_[k]);
        });
    }

  private:
    float dash() const { return theme_.px(10.0f); }
    float gap() const { return theme_.px(5.0f); }
    float apart() const { return theme_.px(11.0f); }
    float width_of(std::size_t k) const { return dash() + gap() + text_width(*theme_.small, names_[k]); }
    /// Calls `entry(index, x, y)` with every entry's place.
    template <class Entry>
    void for_each(Entry&& entry) const {
        float x = 0.0f;
        float y = 0.0f;
        for (std::size_t k = 0; k < names_.size(); ++k) {
            if (x > 0.0f && x + width_of(k) > room_ + 1.0f) {
                x = 0.0f;
                y += theme_.small->FontSize + theme_.px(4.0f);
            }
            entry(k, x, y);
            x += width_of(k) + apart();
        }
    }

    const Theme& theme_;
    std::span<const LegendEntry> entries_;
    std::vector<std::string> names_;
    float room_;
};

/// What is below the frame: numbers and air.
float footer(const Theme& theme) {
    return theme.small->FontSize + theme.px(9.0f);
}

/// A text under the x axis.
struct Label {
    std::string text;
    float left;
    float right;
};

/// Puts the axis' name at its end, where numbers give way to it; but between the last two if fewer than two
/// would remain.
void place_name(const Theme& theme, const Plot& plot, const Frame& frame, std::vector<Label>& labels) {
    const ImFont& small = *theme.small;
    const float longest = longest_name * (frame.high.x - frame.low.x);
    Label name{std::string(plot.x_name), 0.0f, 0.0f};
    if (!plot.x_unit.empty()) name.text += ", " + std::string(plot.x_unit);
    if (text_width(small, name.text) > longest) name.text = fitted(small, plot.x_name, longest);
    const float wide = text_width(small, name.text);
    const float apart = theme.px(8.0f);
    name.right = frame.high.x;
    name.left = name.right - wide;
    const auto hides = [&](const Label& label) { return label.right + apart > name.left; };
    if (labels.size() == 2 && hides(labels.back())) {
        const float from = labels.front().right;
        const float to = labels.back().left;
        if (to - from >= wide + 2.0f * apart) {
            name.left = 0.5f * (from + to - wide);
            name.right = name.left + wide;
        }
    }
    std::erase_if(labels, [&](const Label& label) {
        return label.right + apart > name.left && label.left < name.right + apart;
    });
    labels.push_back(name);
}

}  // namespace

float sharp(float pixel) {
    return std::floor(pixel) + 0.5f;
}

float curve_thickness(const Theme& theme) {
    return std::max(1.0f, theme.px(1.5f));
}

Card place_card(const Plot& plot) {
    const float width =
        std::floor(std::max(1.0f, plot.size.x > 0.0f ? plot.size.x : ImGui::GetContentRegionAvail().x));
    const float height = std::floor(std::max(1.0f, plot.size.y));
    const ImVec2 cursor = ImGui::GetCursorScreenPos();
    const ImVec2 low{std::floor(cursor.x), std::floor(cursor.y)};
    const ImVec2 high{low.x + width, low.y + height};
    ImGui::PushID(plot.title.data(), plot.title.data() + plot.title.size());
    ImGui::InvisibleButton("plot", {width, height});
    const bool hovered = ImGui::IsItemHovered();
    ImGui::PopID();
    return {low, high, hovered, ImGui::IsRectVisible(low, high)};
}

float draw_card(ImDrawList& list, const Theme& theme, const Plot& plot, std::span<const LegendEntry> entries,
                const Card& card) {
    list.AddRectFilled(card.low, card.high, theme.palette.card, theme.px(5.0f));
    const ImFont& body = *theme.body;
    const ImFont& small = *theme.small;
    const float left = card.low.x + theme.px(pad_points);
    const float right = card.high.x - theme.px(pad_points);
    const float title_y = card.low.y + theme.px(6.0f);
    const float small_y = title_y + body.Ascent - small.Ascent;

    const std::string title = fitted(body, plot.title, right - left);
    add_text(list, body, {left, title_y}, theme.palette.text, title);
    float title_end = left + text_width(body, title);
    const float unit_x = title_end + theme.px(6.0f);
    const float unit_end = unit_x + text_width(small, plot.unit);
    if (!plot.unit.empty() && unit_end <= right) {
        add_text(list, small, {unit_x, small_y}, theme.palette.text_dim, plot.unit);
        title_end = unit_end;
    }

    float top = card.low.y + theme.px(8.0f) + body.FontSize;
    const float air = theme.px(8.0f);
    const Legend legend(theme, entries, right - left);
    if (right - legend.width() >= title_end + theme.px(12.0f)) {
        legend.draw(list, {right - legend.width(), small_y});
        return top + air;
    }
    const float lines = legend.height() + theme.px(5.0f);
    if (card.high.y - footer(theme) - (top + lines + air) >= theme.px(lowest_frame_with_legend)) {
        legend.draw(list, {left, top + theme.px(3.0f)});
        top += lines;
    }
    return top + air;
}

std::optional<Axes> lay_out_axes(const Theme& theme, const Plot& plot, const Card& card, float top,
                                 Interval x, Interval y) {
    Frame frame{{card.low.x + theme.px(pad_points), top},
                {card.high.x - theme.px(10.0f), card.high.y - footer(theme)},
                x,
                y,
                plot.log_x,
                plot.log_y};
    const float height = frame.high.y - frame.low.y;
    if (height < theme.px(lowest_frame) || card.high.x - card.low.x < theme.px(110.0f)) return std::nullopt;
    const auto rows = [&](float lines) {
        return std::clamp(static_cast<int>(height / (lines * theme.small->FontSize)), 1, 6);
    };
    const Ticks y_ticks =
        plot.log_y ? log_ticks(y.lo, y.hi, rows(1.4f)) : linear_ticks(y.lo, y.hi, rows(2.6f));
    float labels = 0.0f;
    for (const double value : y_ticks.values) {
        labels = std::max(labels, text_width(*theme.small, tick_label(value, y_ticks)));
    }
    // One indent for plots stacked in a column, unless a label needs more.
    frame.low.x += std::max(std::ceil(labels), theme.px(36.0f)) + theme.px(6.0f);
    // Powers of ten are short.
    const float mark = theme.px(plot.log_x ? 36.0f : 56.0f);
    const int marks = std::clamp(static_cast<int>((frame.high.x - frame.low.x) / mark), 1, 8);
    return Axes{frame, plot.log_x ? log_ticks(x.lo, x.hi, marks) : linear_ticks(x.lo, x.hi, marks), y_ticks};
}

void draw_axes(ImDrawList& list, const Theme& theme, const Plot& plot, const Axes& axes, const Card& card) {
    const ImFont& small = *theme.small;
    const Frame& frame = axes.frame;
    for (const double value : axes.y.values) {
        const float y = sharp(frame.to_y(value));
        list.AddLine({frame.low.x, y}, {frame.high.x, y}, theme.palette.grid, theme.thin());
        const std::string label = tick_label(value, axes.y);
        add_text(list, small,
                 {frame.low.x - theme.px(6.0f) - text_width(small, label), y - 0.5f * small.FontSize},
                 theme.palette.text_dim, label);
    }

    const float text_y = frame.high.y + theme.px(4.0f);
    std::vector<Label> labels;
    for (const double value : axes.x.values) {
        const float x = sharp(frame.to_x(value));
        list.AddLine({x, frame.low.y}, {x, frame.high.y}, theme.palette.grid, theme.thin());
        Label label{tick_label(value, axes.x), 0.0f, 0.0f};
        const float wide = text_width(small, label.text);
        label.left = std::min(x - 0.5f * wide, card.high.x - theme.px(4.0f) - wide);
        label.right = label.left + wide;
        if (labels.empty() || label.left >= labels.back().right + theme.px(8.0f)) labels.push_back(label);
    }
    if (!plot.x_name.empty()) place_name(theme, plot, frame, labels);
    for (const Label& label : labels) {
        add_text(list, small, {label.left, text_y}, theme.palette.text_dim, label.text);
    }
}

void draw_emptiness(ImDrawList& list, const Theme& theme, const Plot& plot, const Frame& frame,
                    const Card& card) {
    const ImFont& small = *theme.small;
    const std::string text = fitted(small, plot.empty_text, card.high.x - card.low.x);
    add_text(list, small,
             {0.5f * (card.low.x + card.high.x - text_width(small, text)),
              0.5f * (frame.low.y + frame.high.y - small.FontSize)},
             theme.palette.text_dim, text);
}

std::optional<float> draw_hairline(ImDrawList& list, const Theme& theme, const Frame& frame, double x) {
    if (!(x >= frame.x.lo && x <= frame.x.hi)) return std::nullopt;
    const float pixel = sharp(frame.to_x(x));
    list.AddLine({pixel, frame.low.y}, {pixel, frame.high.y}, theme.palette.hairline, theme.thin());
    return pixel;
}

std::optional<double> hovered_x(const Card& card, const Frame& frame) {
    const float mouse = ImGui::GetIO().MousePos.x;
    if (!card.hovered || mouse < frame.low.x || mouse > frame.high.x) return std::nullopt;
    return frame.from_x(mouse);
}

void show_values(const Theme& theme, const Plot& plot, double x, std::span<const ValueRow> rows) {
    float labels = 0.0f;
    for (const ValueRow& row : rows) labels = std::max(labels, text_width(*theme.body, row.label));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(12.0f), theme.px(9.0f)));
    ImGui::BeginTooltip();
    ImGui::Text("%.*s = %s", static_cast<int>(plot.x_name.size()), plot.x_name.data(), figure(x, 6).c_str());
    for (const ValueRow& row : rows) {
        ImGui::PushStyleColor(ImGuiCol_Text, row.colour);
        ImGui::TextUnformatted(row.label.data(), row.label.data() + row.label.size());
        ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + labels + theme.px(12.0f));
        ImGui::TextUnformatted(row.value ? reading(*row.value).c_str() : "–");
        ImGui::PopStyleColor();
    }
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

}  // namespace whorl::app
