// Pictures that go into files: sheets of fields with a title, a colour bar, plots and a caption.
#pragma once

#include <memory>
#include <optional>

#include "app/figure/sheet.h"
#include "core/io/png.h"

namespace whorl::app {

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
    /// @throws std::invalid_argument if the request does not pass `check` or a mask has another size.
    Image render(SheetRequest request);

    /// The same piece by piece, so that a window can go on in between: begins a picture, and gives up one
    /// that has been begun. What the request points to must stay as it is until the last band is drawn.
    /// @throws as render
    void begin(SheetRequest request);
    /// Draws the next band of what was begun, from the top; a few milliseconds' work.
    /// @return the picture, with the last band
    /// @throws std::invalid_argument as render
    std::optional<Image> draw_band();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// One picture.
Image render_picture(const SheetRequest& request);

}  // namespace whorl::app
