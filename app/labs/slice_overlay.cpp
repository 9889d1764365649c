#include "app/labs/slice_overlay.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/labs/list.h"
#include "app/run/run_control.h"
#include "app/run/shared_state.h"

namespace whorl::app {
namespace {

constexpr float end_radius = 5;  // points
constexpr float end_reach = 9;   // points from an end's middle
constexpr float line_reach = 5;  // points from the line, on either side
constexpr float rim = 1.5f;      // points, dark around what is drawn, so that it shows on any field
constexpr ImU32 rim_colour = IM_COL32(0, 0, 0, 150);

/// The line on one tile, pixels.
struct TileLine {
    glm::dvec2 from, to;

    /// The part of it that is nearest to a pixel, 0 to 1.
    double nearest(glm::dvec2 pixel) const {
        const glm::dvec2 along = to - from;
        return std::clamp(glm::dot(pixel - from, along) / glm::dot(along, along), 0.0, 1.0);
    }
    glm::dvec2 at(double part) const { return from + part * (to - from); }
};

TileLine on_tile(const SliceLine& line, const SessionSnapshot& session, const FieldViewports& place,
                 const FieldTile& tile) {
    const GridLine placed = place_line(line, session.lanes[tile.lane].grid());
    return {place.pixel(tile, placed.world(0)), place.pixel(tile, placed.world(1))};
}

/// Whether a point is shown; one on the tile's far sides is.
bool shows(const FieldTile& tile, glm::dvec2 at) {
    const PixelRect& part = tile.part;
    constexpr double rounding = 0.5;
    return at.x >= part.x - rounding && at.y >= part.y - rounding && at.x <= part.x + part.width + rounding &&
           at.y <= part.y + part.height + rounding;
}

ImVec2 vec(glm::dvec2 at) {
    return {static_cast<float>(at.x), static_cast<float>(at.y)};
}

void draw_disc(ImDrawList& list, const Theme& theme, glm::dvec2 at, float radius, ImU32 colour) {
    list.AddCircleFilled(vec(at), theme.px(radius) + theme.px(rim), rim_colour);
    list.AddCircleFilled(vec(at), theme.px(radius), colour);
}

void draw_line(ImDrawList& list, const Theme& theme, const FieldTile& tile, const TileLine& line, bool held) {
    list.PushClipRect({static_cast<float>(tile.part.x), static_cast<float>(tile.part.y)},
                      {static_cast<float>(tile.part.x + tile.part.width),
                       static_cast<float>(tile.part.y + tile.part.height)},
                      true);
    list.AddLine(vec(line.from), vec(line.to), rim_colour, theme.px(held ? 4 : 3));
    list.AddLine(vec(line.from), vec(line.to), held ? theme.palette.accent : faded(theme.palette.text, 0.85f),
                 theme.px(held ? 2 : 1));
    list.PopClipRect();
}

}  // namespace

std::optional<SliceHit> hit_slice(const SliceLine& line, const SessionSnapshot& session,
                                  const FieldViewports& place, glm::dvec2 pixel, float point) {
    if (place.covered) return std::nullopt;
    for (const FieldTile& tile : place.tiles) {
        const TileLine here = on_tile(line, session, place, tile);
        const double from = shows(tile, here.from) ? glm::distance(pixel, here.from) : HUGE_VAL;
        const double to = shows(tile, here.to) ? glm::distance(pixel, here.to) : HUGE_VAL;
        if (std::min(from, to) <= static_cast<double>(end_reach * point)) {
            const bool first = from < to;
            return SliceHit{first ? SliceGrip::From : SliceGrip::To, tile.lane, first ? 0.0 : 1.0};
        }
        if (!tile.contains(pixel.x, pixel.y)) continue;
        const double part = here.nearest(pixel);
        if (glm::distance(pixel, here.at(part)) <= static_cast<double>(line_reach * point))
            return SliceHit{SliceGrip::Whole, tile.lane, part};
    }
    return std::nullopt;
}

void SliceOverlay::draw(const FieldViewports& fields, ImDrawList& list, bool) {
    if (!slice_.open) return;
    const Theme& theme = ui_.theme;
    const SliceGrip grip = slice_.grip();
    if (grip != SliceGrip::None)
        ImGui::SetMouseCursor(grip == SliceGrip::Whole ? ImGuiMouseCursor_ResizeAll : ImGuiMouseCursor_Hand);
    const auto pointed = slice_.pointed_on_field ? slice_.pointed_on_field : slice_.pointed_in_plot;
    for (const FieldTile& tile : fields.tiles) {
        const TileLine line = on_tile(slice_.line, run_.session(), fields, tile);
        draw_line(list, theme, tile, line, grip == SliceGrip::Whole);
        const auto colour = [&](SliceGrip end) {
            return grip == end ? theme.palette.accent : theme.palette.text;
        };
        list.PushClipRectFullScreen();  // ends on the domain's edge are whole
        if (shows(tile, line.from)) draw_disc(list, theme, line.from, end_radius, colour(SliceGrip::From));
        if (shows(tile, line.to)) {
            draw_disc(list, theme, line.to, end_radius, colour(SliceGrip::To));
            list.AddCircleFilled(vec(line.to), theme.px(end_radius - 2), theme.palette.background);
        }
        if (pointed && shows(tile, line.at(*pointed)))
            draw_disc(list, theme, line.at(*pointed), 3.5f, theme.palette.accent);
        list.PopClipRect();
        const std::string lane = std::to_string(tile.lane + 1);
        const float side = 2 * theme.px(end_radius);
        const auto note = [&](const char* key, glm::dvec2 at) {
            ui_.log.rect(key + lane, vec(at).x - side / 2, vec(at).y - side / 2, side, side);
        };
        note("line-from=", line.from);
        note("line-to=", line.to);
    }
}

const OverlayEntry slice_overlay{.key = "slice",
                                 .make = [](const Services& s) -> std::unique_ptr<FieldOverlay> {
                                     return std::make_unique<SliceOverlay>(s.ui, s.run, s.shared.of<Slice>());
                                 }};

}  // namespace whorl::app
