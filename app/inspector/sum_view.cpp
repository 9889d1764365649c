#include "app/inspector/sum_view.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/panels/lesson_text.h"
#include "app/plot/ticks.h"
#include "app/render/text.h"

namespace whorl::app {
namespace {

constexpr int most_parts_open = 6;  // sums of more parts come folded

void small(const Theme& theme, ImU32 colour, const std::string& words) {
    ImGui::PushFont(theme.small);
    draw_wrapped(colour, words);
    ImGui::PopFont();
}

/// The columns of a sum's lines, as wide as its numbers need.
class Columns {
  public:
    /// With as many digits as fit, six at most and four at least.
    Columns(const Theme& theme, const Sum& sum, float room) : theme_(theme) {
        for (const Term& term : sum.terms) label_ = std::max(label_, text_width(*theme.small, term.label));
        label_ += theme.px(10);
        for (digits_ = 6; digits_ > 4; --digits_) {
            measure(sum);
            if (label_ + numbers() <= room) break;
        }
        measure(sum);
        beside_ = label_ + numbers() <= room;
        left_ = beside_ ? room - numbers() : std::max(0.0f, room - numbers());
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
        x = put(x, y, weight_, written(term.weight, digits_), theme_.palette.text);
        x = put(x, y, sign(), " × ", theme_.palette.text_dim);
        x = put(x, y, value_, written(term.value, digits_), theme_.palette.text);
        x = put(x, y, sign(), " = ", theme_.palette.text_dim);
        put(x, y, product_, written(term.product(), digits_), theme_.palette.text);
        ImGui::Dummy({left_ + numbers(), y - corner.y + height});
        return ImGui::IsItemHovered();
    }
    /// The line below: what they add up to.
    void total(double value) const {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float end = corner.x + left_ + numbers();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddLine({end - product_ - theme_.px(4), corner.y}, {end, corner.y}, theme_.palette.text_dim,
                     theme_.thin());
        put(end - product_ - sign(), corner.y + theme_.px(2), sign(), "Σ = ", theme_.palette.text_dim);
        put(end - product_, corner.y + theme_.px(2), product_, written(value, digits_), theme_.palette.text);
        ImGui::Dummy({left_ + numbers(), theme_.mono->FontSize + theme_.px(6)});
    }

  private:
    void measure(const Sum& sum) {
        weight_ = value_ = 0;
        product_ = width(sum.total);
        for (const Term& term : sum.terms) {
            weight_ = std::max(weight_, width(term.weight));
            value_ = std::max(value_, width(term.value));
            product_ = std::max(product_, width(term.product()));
        }
    }
    float width(double value) const { return text_width(*theme_.mono, written(value, digits_)); }
    float sign() const { return text_width(*theme_.mono, " = "); }
    float numbers() const { return weight_ + value_ + product_ + 2 * sign(); }
    /// At the right end of a column. @return where the next begins
    float put(float x, float y, float column, const std::string& words, ImU32 colour) const {
        const float wide = text_width(*theme_.mono, words);
        add_text(*ImGui::GetWindowDrawList(), *theme_.mono, {std::floor(x + column - wide), y}, colour,
                 words);
        return x + column;
    }

    const Theme& theme_;
    int digits_ = 6;
    float label_ = 0, weight_ = 0, value_ = 0, product_ = 0;
    bool beside_ = true;  ///< labels stand beside the numbers, else above them
    float left_ = 0;      ///< of the numbers
};

class SumView {
  public:
    SumView(PanelContext& context, const Explanation& explanation, Inspector& inspector)
        : theme_(context.theme), explanation_(explanation), inspector_(inspector) {}

    /// @param place  among the parts of the sum that it is a part of
    void draw(const Sum& sum, std::size_t place, bool open) {
        ImGui::PushID(static_cast<int>(place));
        const bool shown = heading_line(sum, open);
        if (shown) {
            const float indent = theme_.px(8);
            ImGui::Indent(indent);
            small(theme_, theme_.palette.text_dim, sum.equation);
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
        for (std::size_t k = 0; k < sum.terms.size(); ++k) {
            const ImVec2 corner = ImGui::GetCursorScreenPos();
            if (!columns.line(sum.terms[k])) continue;
            const std::optional<std::size_t> step = step_of(sum);
            if (!step) continue;
            inspector_.pointed = {*step, k};
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
        if (!s.acted()) return;
        words = "limited to " + pair("δᵢ", s.limited_left, "δᵢ₊₁", s.limited_right);
        if (s.D != 0) words += ", " + pair("α", s.limited_alpha(), "β", s.limited_beta());
        small(theme_, theme_.palette.accent, words + "  (" + s.equation + ")");
    }

    void cut(const Cut& cut) const {
        std::string words = cut.by + ": the enclosing nodes hold " + written(cut.low, 6) + " to " +
                            written(cut.high, 6) + "; ";
        if (!cut.acted()) {
            words += "nothing to do";
        } else if (cut.first_order && cut.after == *cut.first_order) {
            words += "back to first order, " + written(cut.after, 6);
        } else {
            words += "cut to " + written(cut.after, 6);
        }
        small(theme_, cut.acted() ? theme_.palette.accent : theme_.palette.text_dim,
              words + "  (" + cut.equation + ")");
    }

    const Theme& theme_;
    const Explanation& explanation_;
    Inspector& inspector_;
};

}  // namespace

std::string written(double value, int digits) {
    return figure(value + 0.0, digits);
}

void draw_sums(PanelContext& context, const Explanation& explanation, Inspector& inspector) {
    inspector.pointed.reset();
    SumView(context, explanation, inspector).draw(explanation.sum, 0, true);
}

}  // namespace whorl::app
