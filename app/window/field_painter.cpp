#include "app/window/field_painter.h"

#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>

namespace whorl::app {

namespace {

void clear_to(ImU32 colour) {
    const ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
    glClearColor(c.x, c.y, c.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

void FieldPainter::clear(const Theme& theme, const BackgroundRects& backgrounds, int framebuffer_height) {
    clear_to(theme.palette.background);
    glEnable(GL_SCISSOR_TEST);
    for (const BackgroundRects::Rect& rect : backgrounds.all()) {
        const int x = static_cast<int>(rect.low.x);
        const int bottom = static_cast<int>(rect.high.y);
        glScissor(x, framebuffer_height - bottom, static_cast<int>(rect.high.x) - x,
                  bottom - static_cast<int>(rect.low.y));
        clear_to(rect.colour);
    }
    glDisable(GL_SCISSOR_TEST);
}

void FieldPainter::upload(const Snapshot& snapshot, const LaneFields& fields, std::size_t lane, Part& part) {
    if (part.version == fields.version()) return;
    part.version = fields.version();
    part.texture.upload(*fields.of(lane));
    if (part.mask == snapshot.solids()) return;
    part.mask = snapshot.solids();
    part.solids.upload(part.mask, snapshot.grid().nx, snapshot.grid().ny);
}

void FieldPainter::draw(const SessionSnapshot& session, const LaneFields& fields, const ViewSettings& view,
                        const FieldViewports& place, const Theme& theme, int framebuffer_height) {
    const ColourMap& map = view.map(fields.view(), fields.difference());
    const auto drawing = [&](const FieldTile& tile) {
        FieldDraw draw;
        draw.rect = tile.rect;
        draw.clip = tile.part;
        draw.framebuffer_height = framebuffer_height;
        draw.scale = theme.scale;
        draw.lo = view.range.ends().lo;
        draw.hi = view.range.ends().hi;
        draw.crisp = view.crisp || fields.view().of_limiters;
        draw.window = place.window;
        draw.cells = {session.lanes[tile.lane].grid().nx, session.lanes[tile.lane].grid().ny};
        return draw;
    };
    // One scale for the arrows of all lanes.
    float fastest = 0;
    for (const FieldTile& tile : place.tiles) {
        const Snapshot& s = session.lanes[tile.lane];
        if (view.arrows)
            fastest =
                std::max(fastest, arrows_.fastest(s.state.velocity, drawing(tile), {.solids = s.solids()}));
    }
    for (const FieldTile& tile : place.tiles) {
        if (fields.of(tile.lane) == nullptr) continue;
        const Snapshot& s = session.lanes[tile.lane];
        while (parts_.size() <= tile.lane) parts_.emplace_back();
        Part& part = parts_[tile.lane];
        upload(s, fields, tile.lane, part);
        const FieldDraw draw = drawing(tile);
        field_view_.draw(part.texture, map, draw);
        if (!part.solids.empty()) part.solids.draw(map, draw);
        if (view.arrows) arrows_.draw(s.state.velocity, draw, {.full_speed = fastest, .solids = s.solids()});
    }
}

}  // namespace whorl::app
