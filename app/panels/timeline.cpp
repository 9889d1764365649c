#include "app/panels/timeline.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace whorl::app {
namespace {

std::string help_text() {
    return "Drag to go to any step of the run; it is worked out again from checkpoints, and stands "
           "paused there. What you do there replaces what came after. Keys: ← and → a step, Home and End.";
}

std::string memory_text() {
    return "Checkpoints take up to " + std::to_string(Session::checkpoints_limit >> 20) +
           " MB; when that is full, every other one goes and going back takes longer.";
}

/// What the line under the slider says, from all of it to what fits.
std::string state_line(const SessionSnapshot& session, std::optional<long> target, float width) {
    const std::string step = std::to_string(session.step);
    const std::string last = std::to_string(session.last_step);
    std::vector<std::string> lines;
    if (target && *target != session.step) {
        lines = {"at step " + step + ", on the way to " + std::to_string(*target),
                 "going to " + std::to_string(*target)};
    } else if (session.step < session.last_step) {
        lines = {"step " + step + " of " + last + " · replays what was recorded",
                 "step " + step + " of " + last + " · replay", step + " / " + last};
    } else {
        lines = {"step " + step};
    }
    for (const std::string& line : lines) {
        if (ImGui::CalcTextSize(line.c_str()).x <= width) return line;
    }
    return lines.back();
}

}  // namespace

void draw_timeline(Ui& ui, RunControl& run) {
    const Theme& theme = ui.theme;
    const Palette& palette = theme.palette;
    const SessionSnapshot& session = run.session();
    const std::optional<long> target = run.seek_target();
    const long last = std::max(1L, session.last_step);

    const float width = ImGui::GetContentRegionAvail().x;
    const float height = theme.px(18);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("timeline", {width, height});
    const bool held = ImGui::IsItemActive();
    const bool hovered = ImGui::IsItemHovered();
    const float radius = theme.px(6);
    const float left = corner.x + radius;
    const float span = width - 2 * radius;
    const auto pixel = [&](long step) {
        return left + span * static_cast<float>(std::clamp(step, 0L, last)) / static_cast<float>(last);
    };
    if (held) {
        const float share = std::clamp((ImGui::GetIO().MousePos.x - left) / span, 0.0f, 1.0f);
        const long to = std::lround(static_cast<double>(share) * static_cast<double>(session.last_step));
        if (to != target.value_or(session.step)) run.seek(to);
    }
    ui.explain("timeline", {"Timeline", help_text(), memory_text(), "", ""});

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = std::floor(corner.y + 0.5f * height);
    const float thick = theme.px(2);
    const float here = pixel(session.step);
    list.AddRectFilled({left, middle - thick}, {left + span, middle + thick}, palette.frame, thick);
    if (here > left)
        list.AddRectFilled({left, middle - thick}, {here, middle + thick}, faded(palette.accent, 0.75f),
                           thick);
    if (target && *target != session.step) {
        list.AddCircle({pixel(*target), middle}, radius - theme.px(0.5f), palette.text, 0, theme.px(1.5f));
        list.AddCircleFilled({here, middle}, theme.px(4), palette.accent);
    } else {
        list.AddCircleFilled({here, middle}, radius, held || hovered ? palette.text : palette.accent);
    }
    ImGui::PushFont(theme.small);
    text(palette.text_dim, state_line(session, target, width));
    if (!session.complete) {
        ImGui::PushTextWrapPos(0);
        text(palette.accent, "The recording is full: what is done from here on is not saved or replayed.");
        ImGui::PopTextWrapPos();
    }
    ImGui::PopFont();
}

}  // namespace whorl::app
