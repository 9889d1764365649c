#include "app/window/field_painter.h"

#include <epoxy/gl.h>
#include <imgui.h>

namespace whorl::app {

void FieldPainter::draw(const Snapshot& snapshot, const Field& field, const ViewState& view,
                        const FieldPlacement& place, const Theme& theme, int framebuffer_height) {
    const ImVec4 background = ImGui::ColorConvertU32ToFloat4(theme.palette.background);
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (!place.drawn()) return;
    if (serial_ != snapshot.serial || view_ != view.shown) {
        texture_.upload(field);
        solids_.upload(snapshot.solids, snapshot.grid.nx, snapshot.grid.ny);
        serial_ = snapshot.serial;
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
