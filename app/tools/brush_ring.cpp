// A ring where the brush is, on the field under the pointer, and fainter at the same place of the others.
#include "app/run/run_control.h"
#include "app/tools/list.h"
#include "app/ui/ui.h"

namespace whorl::app {
namespace {

class BrushRing final : public FieldOverlay {
  public:
    BrushRing(const Theme& theme, const RunView& run) : theme_(theme), run_(run) {}

    void draw(const FieldViewports& fields, ImDrawList& list, bool claimed) override {
        const ImGuiIO& io = ImGui::GetIO();
        const FieldTile* under =
            fields.at(static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y));
        if (claimed || under == nullptr) return;
        const WorldPoint at =
            fields.world(*under, static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y));
        const double shown = static_cast<double>(fields.window.high.x - fields.window.low.x);
        const float line = theme_.px(1);
        const ImU32 colour = io.KeyShift || io.KeyCtrl ? theme_.palette.series[1] : theme_.palette.accent;
        for (const FieldTile& tile : fields.tiles) {
            if (&tile != under && fields.wipe) continue;
            const float strength = &tile == under ? 1.0f : 0.45f;
            const glm::dvec2 pixel = fields.pixel(tile, at);
            const ImVec2 middle{static_cast<float>(pixel.x), static_cast<float>(pixel.y)};
            const auto radius =
                static_cast<float>(run_.scene().brush.radius * tile.rect.width / (tile.width * shown));
            list.PushClipRect({static_cast<float>(tile.rect.x), static_cast<float>(tile.rect.y)},
                              {static_cast<float>(tile.rect.x + tile.rect.width),
                               static_cast<float>(tile.rect.y + tile.rect.height)},
                              true);
            list.AddCircle(middle, radius + line, faded(IM_COL32(0, 0, 0, 140), strength), 0, line);
            list.AddCircle(middle, radius, faded(colour, strength), 0, line);
            list.PopClipRect();
        }
    }

  private:
    const Theme& theme_;
    const RunView& run_;
};

}  // namespace

const OverlayEntry brush_ring{.key = "brush", .make = [](const Services& s) -> std::unique_ptr<FieldOverlay> {
                                  return std::make_unique<BrushRing>(s.ui.theme, s.run);
                              }};

}  // namespace whorl::app
