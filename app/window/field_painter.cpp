#include "app/window/field_painter.h"

#include <epoxy/gl.h>
#include <imgui.h>

namespace whorl::app {

namespace {

void clear_to(ImU32 colour) {
    const ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
    glClearColor(c.x, c.y, c.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

void FieldPainter::clear(const Theme& theme, const Slabs& slabs, int framebuffer_height) {
    clear_to(theme.palette.background);
    glEnable(GL_SCISSOR_TEST);
    for (const Slabs::Slab& slab : slabs.all()) {
        const int x = static_cast<int>(slab.low.x);
        const int bottom = static_cast<int>(slab.high.y);
        glScissor(x, framebuffer_height - bottom, static_cast<int>(slab.high.x) - x,
                  bottom - static_cast<int>(slab.low.y));
        clear_to(slab.colour);
    }
    glDisable(GL_SCISSOR_TEST);
}

void FieldPainter::draw(const Snapshot& snapshot, std::uint64_t serial, const Field& field,
                        const ViewState& view, const FieldPlacement& place, const Theme& theme,
                        int framebuffer_height) {
    if (!place.drawn()) return;
    if (serial_ != serial || view_ != view.shown) {
        texture_.upload(field);
        solids_.upload(snapshot.solids, snapshot.grid.nx, snapshot.grid.ny);
        serial_ = serial;
        view_ = view.shown;
    }
    FieldDraw draw;
    draw.rect = place.rect;
    draw.framebuffer_height = framebuffer_height;
    draw.scale = theme.scale;
    draw.lo = view.range.ends().lo;
    draw.hi = view.range.ends().hi;
    draw.crisp = view.crisp;
    draw.cells = {snapshot.grid.nx, snapshot.grid.ny};
    field_view_.draw(texture_, view.map(), draw);
    if (!solids_.empty()) solids_.draw(view.map(), draw);
    if (view.arrows) arrows_.draw(snapshot.velocity, draw, {.solids = snapshot.solids});
}

}  // namespace whorl::app
