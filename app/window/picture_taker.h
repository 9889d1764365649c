// F12: the field as a numbered PNG.
#pragma once

#include <future>
#include <memory>
#include <string>

#include "app/panels/notices.h"
#include "app/panels/view_state.h"
#include "app/render/picture.h"
#include "app/window/trace.h"

namespace whorl::app {

/// Draws on the window's thread, between two frames; writes on another one, so that no frame waits for a
/// disk.
class PictureTaker {
  public:
    void ask() { asked_ = true; }
    /// Takes the picture that was asked for, if any, and says what became of the last one.
    void end_frame(const Snapshot& snapshot, const ViewState& view, Notices& notices, Trace& trace);

  private:
    struct Outcome {
        std::string path;
        std::string error;  ///< empty if all went well
    };

    void take(const Snapshot& snapshot, const ViewState& view, Notices& notices);

    bool asked_ = false;
    std::unique_ptr<PictureRenderer> renderer_;  ///< made for the first picture
    std::future<Outcome> writing_;
};

}  // namespace whorl::app
