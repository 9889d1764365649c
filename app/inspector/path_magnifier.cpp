#include "app/inspector/path_magnifier.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/inspector/overlay.h"
#include "app/inspector/sum_view.h"
#include "app/render/text.h"
#include "app/ui/wrapped_text.h"

namespace whorl::app {
namespace {

/// A path with its name.
struct Named {
    const char* name;
    WorldPoint end;
    ImU32 colour;
};

double distance(WorldPoint a, WorldPoint b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// A length of 1, 2 or 5 times a power of ten, at most `most`.
double round_below(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double part : {5.0, 2.0}) {
        if (part * power <= most) return part * power;
    }
    return power;
}

void draw_magnified(const Theme& theme, const std::array<Named, 3>& paths, WorldPoint start, double h,
                    ImVec2 low, float side) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high{low.x + side, low.y + side};
    list.AddRectFilled(low, high, theme.palette.card, theme.px(5));
    const WorldPoint exact = paths.back().end;
    double reach = 0;
    for (const Named& path : paths) reach = std::max(reach, distance(path.end, exact));
    // Where all end on one spot, a hundredth of a cell is seen.
    reach = std::max(reach, 0.01 * h);
    const ImVec2 middle{low.x + 0.5f * side, low.y + 0.5f * side};
    const double scale = static_cast<double>(0.38f * side) / reach;
    const auto at = [&](WorldPoint p) {
        return ImVec2(middle.x + static_cast<float>((p.x - exact.x) * scale),
                      middle.y - static_cast<float>((p.y - exact.y) * scale));
    };
    list.PushClipRect(low, high, true);
    for (const Named& path : paths) {
        // Seen so close, a path is a straight line from far off.
        const double far = distance(start, path.end);
        const double part = far > 0 ? std::min(1.0, 4 * reach / far) : 0;
        const WorldPoint from{path.end.x + part * (start.x - path.end.x),
                              path.end.y + part * (start.y - path.end.y)};
        list.AddLine(at(from), at(path.end), faded(path.colour, 0.6f), theme.px(1));
    }
    for (const Named& path : paths) {
        const ImVec2 end = at(path.end);
        list.AddCircleFilled(end, theme.px(4.5f), theme.palette.card);
        list.AddCircleFilled(end, theme.px(3.5f), path.colour);
    }
    // The scale, in cells.
    const double bar = round_below(0.8 * reach / h);
    // At the foot, or where something ends there, at the top.
    const bool at_top = std::any_of(paths.begin(), paths.end(), [&](const Named& path) {
        return at(path.end).y > middle.y + 0.15f * side;
    });
    const float foot = at_top ? low.y + theme.small->FontSize + theme.px(10) : high.y - theme.px(7);
    const ImVec2 bar_low{low.x + theme.px(7), foot};
    const std::string length = written(bar, 2) + " cell";
    const ImVec2 words{bar_low.x, bar_low.y - theme.small->FontSize - theme.px(2)};
    list.AddRectFilled({low.x + theme.px(2), words.y},
                       {words.x + text_width(*theme.small, length) + theme.px(4), foot + theme.px(4)},
                       theme.palette.card);
    list.AddLine(bar_low, {bar_low.x + static_cast<float>(bar * h * scale), bar_low.y},
                 theme.palette.text_dim, theme.px(1.5f));
    add_text(list, *theme.small, words, theme.palette.text_dim, length);
    list.PopClipRect();
    list.AddRect(low, high, theme.palette.border, theme.px(5));
}

}  // namespace

void draw_path_magnifier(Ui& ui, const BaseStep& step, double h) {
    const Theme& theme = ui.theme;
    const PathColours colours = path_colours(theme);
    const WorldPoint exact = step.fine.empty() ? step.path.end : step.fine.back();
    const std::array<Named, 3> paths{{{"Euler", step.euler.end, colours.euler},
                                      {"midpoint", step.midpoint.end, colours.midpoint},
                                      {"many small steps", exact, colours.fine}}};
    const float side = theme.px(92);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    ui.explain("inspector-lens",
               {"Where the paths end",
                "Seen close: the departure point by Euler, by midpoint, and by many small steps of a "
                "method of fourth order, which is as good as exact.",
                "The bar is a part of a cell", "thesis eq. 3.3–3.5", ""});
    draw_magnified(theme, paths, step.path.start, h, corner, side);
    const float left = corner.x + side + theme.px(10);
    const float room = corner.x + ImGui::GetContentRegionAvail().x - left;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float y = corner.y + theme.px(2);
    const auto line = [&](ImU32 colour, ImFont& font, const std::string& words) {
        ImGui::PushFont(&font);
        const std::string lines = broken(words, std::max(1.0f, room));
        add_text(list, font, {left, y}, colour, lines);
        y += ImGui::CalcTextSize(lines.c_str()).y + theme.px(4);
        ImGui::PopFont();
    };
    const double path = distance(step.path.start, step.path.end) / h;
    line(theme.palette.text, *theme.small, "path: " + written(path, 3) + " cells");
    line(theme.palette.text_dim, *theme.small, "its end off the exact, in cells:");
    for (std::size_t k = 0; k + 1 < paths.size(); ++k)
        line(paths[k].colour, *theme.mono,
             std::string(paths[k].name) + "  " + written(distance(paths[k].end, exact) / h, 2));
    ImGui::Dummy({0, std::max(theme.px(2), y - corner.y - side)});
}

}  // namespace whorl::app
