#include "app/inspector/inspector_window.h"

#include <imgui.h>

#include <cmath>
#include <utility>
#include <vector>

#include "app/charts/measure_tabs.h"
#include "app/inspector/path_magnifier.h"
#include "app/inspector/sum_view.h"
#include "app/labs/lab_widgets.h"
#include "app/ui/widgets.h"
#include "app/ui/wrapped_text.h"
#include "core/inspect/explain.h"
#include "core/inspect/text.h"

namespace whorl::app {
namespace {

void paragraph(ImFont* font, ImU32 colour, const std::string& words) {
    ImGui::PushFont(font);
    draw_wrapped(colour, words);
    ImGui::PopFont();
}

void quantity_chips(PanelContext& context, Inspector& inspector) {
    const std::vector<FieldId> choices = advected_fields();
    const float width = chip_width(static_cast<int>(choices.size()));
    for (const FieldId quantity : choices) {
        const FieldInfo& what = quantity.info();
        const std::string key = "inspector-quantity=" + std::string(what.key);
        const bool on_face = what.site != Site::Centre;
        const std::string help = std::string(what.title) +
                                 (on_face ? ", on the face nearest to the click." : ", at cell centres.");
        if (lab_chip(context, key, {std::string(what.symbol), help, "", "", ""},
                     inspector.node.quantity == quantity, width, quantity == choices.front()))
            inspector.node.quantity = quantity;
    }
}

/// Why there is nothing to tell, and what would be.
std::string why_not(const PanelContext& context, const Inspector& inspector) {
    if (!inspector.picked) return "Click a cell, in any lane. Shift and an arrow go to its neighbours.";
    const Snapshot& lane = context.snapshot();
    if (lane.failure) return "The lane has stopped: its last step cannot be asked for this any more.";
    if (lane.watched != inspector.watched()) return "";  // on its way
    if (inspector.node.quantity != field::density && !is_solved(lane))
        return std::string(inspector.node.quantity.info().title) +
               " is not moved here: the flow is given. Choose ρ.";
    const AdvectionSetup setup{lane.scene.velocity, lane.scene.scalars};
    if (std::string reason = unexplained(setup.schemes(inspector.node.quantity)); !reason.empty()) {
        reason.front() = 'T';  // "there is no …"
        return reason + ".";
    }
    if (lane.measures.step == 0) return "Nothing has moved yet. Press . for one step.";
    return "The scene was changed after the last step. Press . for one more.";
}

/// The lane, the node, and what it holds.
void head(PanelContext& context, const Explanation& e) {
    const Theme& theme = context.theme;
    const FieldInfo& what = e.quantity.info();
    ImGui::PushFont(theme.title);
    text(theme.palette.text, std::string(what.symbol) + " (" + std::to_string(e.i) + ", " +
                                 std::to_string(e.j) + ") = " + written(e.result, 6));
    ImGui::PopFont();
    context.log.control("inspector-value");
    if (context.names.size() > 1) {
        const std::size_t lane = context.client.selected();
        paragraph(theme.small, theme.lane(static_cast<int>(lane)), context.names.name(lane));
    }
    const auto note = [&](const std::string& words) {
        paragraph(theme.small, theme.palette.text_dim, words);
    };
    if (e.inside())
        note("In a wall: it holds the value of the nearest node that fluid touches, (" +
             std::to_string(e.of_i) + ", " + std::to_string(e.of_j) + "), explained here.");
    if (e.closed)
        note("On a wall, through which nothing flows; else it would be " + written(e.sum.value(), 6) + ".");
    if (e.now != e.result) note("Since then it has become " + written(e.now, 6) + ".");
}

/// A value with its name, at both ends of a line.
void row(const Theme& theme, const char* name, double value, ImU32 colour) {
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(theme.small);
    text(theme.palette.text_dim, name);
    ImGui::PopFont();
    ImGui::PushFont(theme.mono);
    const std::string shown = written(value, 6);
    ImGui::SameLine(right - ImGui::CalcTextSize(shown.c_str()).x);
    text(colour, shown);
    ImGui::PopFont();
}

/// The path to the value in a few lines: what a predictor-corrector made of it, or a sum of particles, and
/// the limiter.
void summary(const Theme& theme, const Explanation& e) {
    const auto line = [&](const char* name, double value) { row(theme, name, value, theme.palette.text); };
    if (e.correction) {
        line("before", e.correction->start);
        line("forward", e.correction->forward);
        line("back again", e.correction->back);
        line("error e = (back − before) / 2", e.correction->error);
        line("corrected", e.sum.total);
    } else if (e.sum.cut) {
        line("sum", e.sum.total);
    }
    if (e.sum.cut && e.sum.cut->acted()) row(theme, "limited", e.sum.value(), theme.palette.accent);
}

void step_chips(PanelContext& context, const Explanation& e, Inspector& inspector) {
    constexpr const char* names[] = {"Forward", "Back", "Again"};
    constexpr const char* help[] = {"Draws the step along the flow over the field.",
                                    "Draws the step against the flow over the field.",
                                    "Draws the second step along the flow, of the corrected field."};
    const float width = chip_width(static_cast<int>(e.steps.size()));
    for (std::size_t k = 0; k < e.steps.size(); ++k) {
        const std::string key = "inspector-step=" + std::to_string(k + 1);
        const bool known = k < std::size(names);
        const TooltipText words{known ? names[k] : std::string_view(e.steps[k].title), known ? help[k] : "",
                                "", "", ""};
        if (lab_chip(context, key, words, inspector.shown(e) == k, width, k == 0)) inspector.step = k;
    }
}

bool button(PanelContext& context, const char* label, const char* key, float width, const char* help) {
    const bool pressed = ImGui::Button(label, {width, 0});
    context.log.control(key);
    context.tooltip.item(context.theme, key, {label, help, "", "", ""});
    return pressed;
}

void buttons(PanelContext& context, const Explanation& e, Inspector& inspector) {
    const bool zooms = context.snapshot().grid().dimensions() == 2;
    const float width = chip_width(zooms ? 2 : 1);
    if (zooms &&
        button(context, "Closer", "inspector-closer", width,
               "Shows the cell, its way and what is read there as large as possible. Key 0 shows the whole "
               "domain."))
        inspector.goes_closer = true;
    if (zooms) ImGui::SameLine(0, std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x));
    if (!button(context, "Copy as text", "inspector-copy", width,
                "All of this as plain text to the clipboard, as `whorl explain` prints it."))
        return;
    const std::string words = write_text(e);
    ImGui::SetClipboardText(words.c_str());
    context.client.notifications().info("Copied the sum as text");
    context.log.event("copied", words);
}

}  // namespace

void draw_inspector_window(PanelContext& context) {
    const Theme& theme = context.theme;
    Inspector& inspector = context.view.labs.inspector;
    quantity_chips(context, inspector);
    const Snapshot& lane = context.snapshot();
    const std::optional<Explanation>& explanation = lane.explanation;
    const bool another = lane.failure && lane.watched != inspector.watched();
    if (!explanation || explanation->quantity != inspector.node.quantity || another) {
        inspector.pointed.reset();
        paragraph(theme.body, theme.palette.text_dim, why_not(context, inspector));
        return;
    }
    const Explanation& e = *explanation;
    // What is shown may still be of the node that was picked before.
    if (lane.watched == inspector.node && std::exchange(inspector.goes_closer, false)) {
        const Grid& grid = lane.grid();
        std::vector<const Explanation*> others;
        for (const Snapshot& other : context.client.session().lanes) {
            if (other.explanation) others.push_back(&*other.explanation);
        }
        context.view.window = window_around(e, others, {grid.width(), grid.height()}, grid.h);
    }
    head(context, e);
    buttons(context, e, inspector);
    ImGui::BeginChild("inspected");
    summary(theme, e);
    if (e.correction) step_chips(context, e, inspector);
    draw_path_magnifier(context, e.steps[inspector.shown(e)], lane.grid().h);
    draw_sums(context, e, inspector);
    ImGui::EndChild();
}

}  // namespace whorl::app
