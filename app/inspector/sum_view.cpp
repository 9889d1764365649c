#include "app/inspector/sum_view.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/render/text.h"
#include "app/ui/wrapped_text.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

constexpr int most_parts_open = 6;  // sums of more parts come folded

void small(const Theme& theme, ImU32 colour, const std::string& words) {
    ImGui::PushFont(theme.small);
    draw_wrapped(colour, words);
    ImGui::PopFont();
}

/// How the numbers of a column are written: all with as many decimals as give the largest its digits, so that
/// their points stand below each other.
class Format {
  public:
    Format(double largest, int digits)
        : digits_(digits),
          decimals_(digits - 1 - (largest > 0 ? static_cast<int>(std::floor(std::log10(largest))) : 0)) {}

    std::string operator()(double value) const {
        // Numbers that are too large or too small for that, and those that it would round away.
        if (decimals_ < 0 || decimals_ > most_decimals || !std::isfinite(value))
            return written(value, digits_);
        if (value != 0 && std::abs(value) < 0.5 * std::pow(10.0, -decimals_)) return written(value, 2);
        char text[64];
        std::snprintf(text, sizeof text, "%.*f", decimals_, std::abs(value));
        return (value < 0 ? "−" : "") + std::string(text);
    }

  private:
    static constexpr int most_decimals = 9;
    int digits_, decimals_;
};

/// The columns of a sum's lines, as wide as their heads and numbers need.
class Columns {
  public:
    /// With as many digits as fit, six at most and three at least. Where even those do not fit beside the
    /// labels, they stand below them.
    Columns(const Theme& theme, const Sum& sum, float room) : theme_(theme) {
        for (const Term& term : sum.terms) label_ = std::max(label_, text_width(*theme.small, term.label));
        label_ += theme.px(10);
        beside_ = fit(sum, room - label_);
        if (!beside_) fit(sum, room);
        left_ = std::max(0.0f, room - numbers());
    }

    /// What the numbers below are.
    void heads() const {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        float end = corner.x + left_;
        for (const Column* column : {&weight_, &value_, &product_}) {
            end += column->width;
            add_text(*ImGui::GetWindowDrawList(), *theme_.small,
                     {std::floor(end - text_width(*theme_.small, column->head)), corner.y},
                     faded(theme_.palette.text_dim, 0.8f), column->head);
            end += sign();
        }
        ImGui::Dummy({left_ + numbers(), theme_.small->FontSize + theme_.px(1)});
    }
    /// One product. @return whether the pointer is on it
    bool line(const Term& term) const {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float height = theme_.mono->FontSize + theme_.px(3);
        float y = corner.y;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        add_text(list, *theme_.small, {corner.x, y}, theme_.palette.text_dim, term.label);
        if (!beside_) y += theme_.small->FontSize + theme_.px(1);
        float x = corner.x + left_;
        x = put(x, y, weight_.width, weight_.format(term.weight), theme_.palette.text);
        x = put(x, y, sign(), " × ", theme_.palette.text_dim);
        x = put(x, y, value_.width, value_.format(term.value), theme_.palette.text);
        x = put(x, y, sign(), " = ", theme_.palette.text_dim);
        put(x, y, product_.width, product_.format(term.product()), theme_.palette.text);
        ImGui::Dummy({left_ + numbers(), y - corner.y + height});
        return ImGui::IsItemHovered();
    }
    /// The line below: what they add up to.
    void total(double value) const {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float end = corner.x + left_ + numbers();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddLine({end - product_.width - theme_.px(4), corner.y}, {end, corner.y},
                     theme_.palette.text_dim, theme_.thin());
        put(end - product_.width - sign(), corner.y + theme_.px(2), sign(), "Σ = ", theme_.palette.text_dim);
        put(end - product_.width, corner.y + theme_.px(2), product_.width, product_.format(value),
            theme_.palette.text);
        ImGui::Dummy({left_ + numbers(), theme_.mono->FontSize + theme_.px(6)});
    }

  private:
    struct Column {
        const char* head;
        Format format{0, 0};
        float width = 0;  ///< pixels
    };

    /// @return whether the numbers fit, with the digits that they then have, or else the least
    bool fit(const Sum& sum, float room) {
        for (int digits = most_digits; digits >= least_digits; --digits) {
            measure(weight_, sum, digits, [](const Term& term) { return term.weight; });
            measure(value_, sum, digits, [](const Term& term) { return term.value; });
            measure(product_, sum, digits, [](const Term& term) { return term.product(); });
            product_.width = std::max(product_.width, text_width(*theme_.mono, product_.format(sum.total)));
            if (numbers() <= room) return true;
        }
        return false;
    }
    template <class Of>
    void measure(Column& column, const Sum& sum, int digits, Of&& of) const {
        double largest = 0;
        for (const Term& term : sum.terms) largest = std::max(largest, std::abs(of(term)));
        column.format = Format(largest, digits);
        column.width = text_width(*theme_.small, column.head);
        for (const Term& term : sum.terms)
            column.width = std::max(column.width, text_width(*theme_.mono, column.format(of(term))));
    }
    float sign() const { return text_width(*theme_.mono, " = "); }
    float numbers() const { return weight_.width + value_.width + product_.width + 2 * sign(); }
    /// At the right end of a column. @return where the next begins
    float put(float x, float y, float column, const std::string& words, ImU32 colour) const {
        const float wide = text_width(*theme_.mono, words);
        add_text(*ImGui::GetWindowDrawList(), *theme_.mono, {std::floor(x + column - wide), y}, colour,
                 words);
        return x + column;
    }

    const Theme& theme_;
    static constexpr int most_digits = 6, least_digits = 3;
    Column weight_{"weight"}, value_{"value"}, product_{"product"};
    float label_ = 0;
    bool beside_ = true;  ///< labels stand beside the numbers, else above them
    float left_ = 0;      ///< of the numbers
};

class SumView {
  public:
    SumView(const Theme& theme, const Explanation& explanation, Inspection& inspection)
        : theme_(theme), explanation_(explanation), inspection_(inspection) {}

    /// @param place  among the parts of the sum that it is a part of
    void draw(const Sum& sum, std::size_t place, bool open) {
        ImGui::PushID(static_cast<int>(place));
        const bool shown = heading_line(sum, open);
        if (shown) {
            const float indent = theme_.px(8);
            ImGui::Indent(indent);
            small(theme_, theme_.palette.text_dim,
                  sum.units.empty() ? sum.equation : sum.equation + "; " + sum.units);
            if (sum.slopes) slopes(*sum.slopes);
            terms(sum);
            if (sum.cut) cut(*sum.cut);
            const bool few = static_cast<int>(sum.parts.size()) <= most_parts_open;
            for (std::size_t k = 0; k < sum.parts.size(); ++k) draw(sum.parts[k], k, few);
            ImGui::Unindent(indent);
        }
        ImGui::PopID();
    }

  private:
    /// The title and the value, with a chevron to fold what is below.
    bool heading_line(const Sum& sum, bool open_at_first) const {
        bool& open = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("open"), open_at_first);
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        const float arm = theme_.px(3), left = 4 * arm;
        const std::string value = written(sum.value(), 6);
        const float wide = text_width(*theme_.mono, value);
        ImGui::PushFont(theme_.bold);
        const std::string title = broken(sum.title, std::max(1.0f, width - left - wide - theme_.px(8)));
        const float height = ImGui::CalcTextSize(title.c_str()).y + theme_.px(7);
        ImGui::PopFont();
        if (ImGui::InvisibleButton("fold", {std::max(width, 1.0f), height})) open = !open;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImU32 colour = ImGui::IsItemHovered() ? theme_.palette.text : theme_.palette.text_dim;
        const ImVec2 middle{corner.x + arm, corner.y + 0.5f * (theme_.bold->FontSize + theme_.px(7))};
        if (open) {
            list.AddTriangleFilled({middle.x - arm, middle.y - 0.6f * arm},
                                   {middle.x + arm, middle.y - 0.6f * arm}, {middle.x, middle.y + arm},
                                   colour);
        } else {
            list.AddTriangleFilled({middle.x - 0.6f * arm, middle.y - arm}, {middle.x + arm, middle.y},
                                   {middle.x - 0.6f * arm, middle.y + arm}, colour);
        }
        const float y = corner.y + theme_.px(4);
        add_text(list, *theme_.bold, {corner.x + left, y}, theme_.palette.text, title);
        add_text(list, *theme_.mono, {std::floor(corner.x + width - wide), y + theme_.px(1)},
                 theme_.palette.text, value);
        return open;
    }

    void terms(const Sum& sum) {
        const Columns columns(theme_, sum, ImGui::GetContentRegionAvail().x);
        columns.heads();
        for (std::size_t k = 0; k < sum.terms.size(); ++k) {
            const ImVec2 corner = ImGui::GetCursorScreenPos();
            if (!columns.line(sum.terms[k])) continue;
            const std::optional<std::size_t> step = step_of(sum);
            if (!step) continue;
            inspection_.pointed = {*step, k};
            const ImVec2 high{corner.x + ImGui::GetContentRegionAvail().x, ImGui::GetItemRectMax().y};
            ImGui::GetWindowDrawList()->AddRectFilled({corner.x - theme_.px(3), corner.y}, high,
                                                      faded(theme_.palette.accent, 0.15f), theme_.px(3));
        }
        columns.total(sum.total);
    }
    std::optional<std::size_t> step_of(const Sum& sum) const {
        for (std::size_t k = 0; k < explanation_.steps.size(); ++k) {
            if (&sum_of(explanation_, k) == &sum) return k;
        }
        return std::nullopt;
    }

    void slopes(const CubicSlopes& s) const {
        const auto pair = [](const char* a, double x, const char* b, double y) {
            return std::string(a) + " = " + written(x, 4) + ", " + b + " = " + written(y, 4);
        };
        std::string words = "D = " + written(s.D, 4) + ", " + pair("δᵢ", s.left, "δᵢ₊₁", s.right);
        if (s.D != 0) words += ", " + pair("α", s.alpha(), "β", s.beta());
        small(theme_, theme_.palette.text_dim, words);
        if (!s.changed()) return;
        words = "limited to " + pair("δᵢ", s.limited_left, "δᵢ₊₁", s.limited_right);
        if (s.D != 0) words += ", " + pair("α", s.limited_alpha(), "β", s.limited_beta());
        small(theme_, theme_.palette.accent, words + "  (" + s.equation + ")");
    }

    void cut(const Clamping& cut) const {
        std::string words = cut.by + ": the enclosing nodes hold " + written(cut.low, 6) + " to " +
                            written(cut.high, 6) + "; ";
        if (!cut.changed()) {
            words += "nothing to do";
        } else if (cut.first_order && cut.after == *cut.first_order) {
            words += "back to first order, " + written(cut.after, 6);
        } else {
            words += "cut to " + written(cut.after, 6);
        }
        small(theme_, cut.changed() ? theme_.palette.accent : theme_.palette.text_dim,
              words + "  (" + cut.equation + ")");
    }

    const Theme& theme_;
    const Explanation& explanation_;
    Inspection& inspection_;
};

}  // namespace

std::string written(double value, int digits) {
    return figure(value + 0.0, digits);
}

void draw_sums(const Theme& theme, const Explanation& explanation, Inspection& inspection) {
    inspection.pointed.reset();
    SumView(theme, explanation, inspection).draw(explanation.sum, 0, true);
}

}  // namespace whorl::app
