// The inspector's window: a node's value taken apart.

#include <imgui.h>

#include <cmath>
#include <utility>
#include <vector>

#include "app/inspector/inspection.h"
#include "app/inspector/list.h"
#include "app/inspector/path_magnifier.h"
#include "app/inspector/sum_view.h"
#include "app/run/run_control.h"
#include "app/run/shared_state.h"
#include "app/run/view_settings.h"
#include "app/ui/ui.h"
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
    if (e.sum.cut && e.sum.cut->changed()) row(theme, "limited", e.sum.value(), theme.palette.accent);
}

class InspectorLab final : public Lab {
  public:
    InspectorLab(Ui& ui, const RunView& run, ViewSettings& view, Inspection& inspection)
        : ui_(ui), run_(run), view_(view), inspection_(inspection) {}

    bool& open() override { return inspection_.open; }
    void draw() override {
        const Theme& theme = ui_.theme;
        quantity_chips();
        const Snapshot& lane = run_.snapshot();
        const std::optional<Explanation>& explanation = lane.explanation;
        const bool another = lane.failure && lane.watched != inspection_.watched();
        if (!explanation || explanation->quantity != inspection_.node.quantity || another) {
            inspection_.pointed.reset();
            paragraph(theme.body, theme.palette.text_dim, unsupported_reason());
            return;
        }
        const Explanation& e = *explanation;
        // What is shown may still be of the node that was picked before.
        if (lane.watched == inspection_.node && std::exchange(inspection_.goes_closer, false)) {
            const Grid& grid = lane.grid();
            std::vector<const Explanation*> others;
            for (const Snapshot& other : run_.session().lanes) {
                if (other.explanation) others.push_back(&*other.explanation);
            }
            view_.window = window_around(e, others, {grid.width(), grid.height()}, grid.h);
        }
        head(e);
        buttons(e);
        ImGui::BeginChild("inspected");
        summary(theme, e);
        if (e.correction) step_chips(e);
        draw_path_magnifier(ui_, e.steps[inspection_.shown(e)], lane.grid().h);
        draw_sums(ui_.theme, e, inspection_);
        ImGui::EndChild();
    }

  private:
    void quantity_chips() {
        const std::vector<FieldId> choices = advected_fields();
        const float width = chip_width(static_cast<int>(choices.size()));
        for (const FieldId quantity : choices) {
            const FieldInfo& what = quantity.info();
            const std::string key = "inspector-quantity=" + std::string(what.key);
            const bool on_face = what.site != Site::Centre;
            const std::string help = std::string(what.title) +
                                     (on_face ? ", on the face nearest to the click." : ", at cell centres.");
            if (ui_.chip_in_row(key, inspection_.node.quantity == quantity, width,
                                quantity == choices.front(), {std::string(what.symbol), help, "", "", ""}))
                inspection_.node.quantity = quantity;
        }
    }

    /// Why there is nothing to tell, and what would be.
    std::string unsupported_reason() const {
        if (!inspection_.picked) return "Click a cell, in any lane. Shift and an arrow go to its neighbours.";
        const Snapshot& lane = run_.snapshot();
        if (lane.failure) return "The lane has stopped: its last step cannot be asked for this any more.";
        if (lane.watched != inspection_.watched()) return "";  // on its way
        if (inspection_.node.quantity != field::density && !is_solved(lane))
            return std::string(inspection_.node.quantity.info().title) +
                   " is not moved here: the flow is given. Choose ρ.";
        const AdvectionSetup setup{lane.scene.velocity, lane.scene.scalars};
        if (std::string reason = unexplained(setup.schemes(inspection_.node.quantity)); !reason.empty()) {
            reason.front() = 'T';  // "there is no …"
            return reason + ".";
        }
        if (lane.measures.step == 0) return "Nothing has moved yet. Press . for one step.";
        return "The scene was changed after the last step. Press . for one more.";
    }

    /// The lane, the node, and what it holds.
    void head(const Explanation& e) {
        const Theme& theme = ui_.theme;
        const FieldInfo& what = e.quantity.info();
        ImGui::PushFont(theme.title);
        text(theme.palette.text, std::string(what.symbol) + " (" + std::to_string(e.i) + ", " +
                                     std::to_string(e.j) + ") = " + written(e.result, 6));
        ImGui::PopFont();
        ui_.log.control("inspector-value");
        if (run_.names().size() > 1) {
            const std::size_t lane = run_.selected();
            paragraph(theme.small, theme.lane(static_cast<int>(lane)), run_.names().name(lane));
        }
        const auto note = [&](const std::string& words) {
            paragraph(theme.small, theme.palette.text_dim, words);
        };
        if (e.inside())
            note("In a wall: it holds the value of the nearest node that fluid touches, (" +
                 std::to_string(e.of_i) + ", " + std::to_string(e.of_j) + "), explained here.");
        if (e.closed)
            note("On a wall, through which nothing flows; else it would be " + written(e.sum.value(), 6) +
                 ".");
        if (e.now != e.result) note("Since then it has become " + written(e.now, 6) + ".");
    }

    void step_chips(const Explanation& e) {
        constexpr const char* names[] = {"Forward", "Back", "Again"};
        constexpr const char* help[] = {"Draws the step along the flow over the field.",
                                        "Draws the step against the flow over the field.",
                                        "Draws the second step along the flow, of the corrected field."};
        const float width = chip_width(static_cast<int>(e.steps.size()));
        for (std::size_t k = 0; k < e.steps.size(); ++k) {
            const std::string key = "inspector-step=" + std::to_string(k + 1);
            const bool known = k < std::size(names);
            const TooltipText words{known ? names[k] : std::string_view(e.steps[k].title),
                                    known ? help[k] : "", "", "", ""};
            if (ui_.chip_in_row(key, inspection_.shown(e) == k, width, k == 0, words)) inspection_.step = k;
        }
    }

    void buttons(const Explanation& e) {
        const bool zooms = run_.snapshot().grid().dimensions() == 2;
        const float width = chip_width(zooms ? 2 : 1);
        if (zooms && ui_.button("Closer", "inspector-closer", width,
                                {"Closer",
                                 "Shows the cell, its path and what is read there as large as possible. Key "
                                 "0 shows the whole "
                                 "domain.",
                                 "", "", ""}))
            inspection_.goes_closer = true;
        if (zooms) ImGui::SameLine(0, std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x));
        if (!ui_.button(
                "Copy as text", "inspector-copy", width,
                {"Copy as text", "All of this as plain text to the clipboard, as `whorl explain` prints it.",
                 "", "", ""}))
            return;
        const std::string words = write_text(e);
        ImGui::SetClipboardText(words.c_str());
        ui_.notifications.info("Copied the sum as text");
        ui_.log.event("copied", words);
    }

    Ui& ui_;
    const RunView& run_;
    ViewSettings& view_;
    Inspection& inspection_;
};

}  // namespace

const LabEntry inspector_lab{
    .key = "inspector",
    .label = "Inspector",
    .help = "Click a cell to see where its value came from: the sum behind it, with its numbers. Key: I",
    .source = "",
    .width = 0,
    .height = 0,
    .anchor = LabEntry::Anchor::Side,
    .make = [](const Services& s) -> std::unique_ptr<Lab> {
        return std::make_unique<InspectorLab>(s.ui, s.run, s.view, s.shared.of<Inspection>());
    }};

}  // namespace whorl::app
