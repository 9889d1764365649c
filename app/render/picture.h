// The picture of a field that goes into a file: title, field, colour bar and caption.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "app/render/colour_map.h"
#include "app/render/field_view.h"
#include "core/grid/field.h"
#include "core/io/png.h"

namespace whorl::app {

/// What a picture shows. What it points to must live until it is drawn.
struct PictureRequest {
    const Field& field;
    const ColourMap& map;
    float lo = 0.0f;                            ///< value at the map's start, the field's unit
    float hi = 1.0f;                            ///< value at the map's end
    std::span<const std::uint8_t> solids = {};  ///< nx × ny, non-zero is solid; empty for none
    const FaceVelocity* arrows = nullptr;       ///< velocity to draw over the field
    glm::ivec2 cells{0, 0};                     ///< size of the domain; 0 takes the field's own shape
    bool crisp = false;                         ///< squares of one value each
    std::string title = {};                     ///< one line, wrapped if it is long
    std::string label = {};                     ///< quantity and unit, at the colour bar
    std::string caption = {};                   ///< schemes, step, time …; lines are wrapped
    int width = 900;                            ///< of the field, about, pixels; text grows with it
    bool light = false;                         ///< dark on white, for paper
};

/// Draws pictures. Its fonts take a moment to load: keep one for a series of pictures.
///
/// Works in any current OpenGL 3.3 context, a window's or an EglContext. It draws with an ImGui context of
/// its own and restores the current one, so call it between two frames of the window, after ImGui::Render.
class PictureRenderer {
  public:
    PictureRenderer();
    ~PictureRenderer();
    PictureRenderer(const PictureRenderer&) = delete;
    PictureRenderer& operator=(const PictureRenderer&) = delete;

    /// The same request gives the same bytes on the same machine.
    /// @throws std::runtime_error if the picture is larger than the driver draws.
    /// @throws std::invalid_argument if the field is empty or the mask has another size.
    Image render(const PictureRequest& request);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// One picture.
Image render_picture(const PictureRequest& request);

}  // namespace whorl::app
