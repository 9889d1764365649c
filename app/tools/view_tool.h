// From wheel, pointer and keys to the part of the domain that is shown, and to where one lane ends.
#pragma once

#include "app/run/tool.h"
#include "app/run/view_settings.h"

namespace whorl::app {

/// Zooms about the pointer, pans, drags the line between two lanes, and shows the other lane while Tab is
/// held.
class ViewTool final : public Tool {
  public:
    explicit ViewTool(ViewSettings& view) : view_(view) {}

    bool take(const InputEvent& event, const FieldViewports& fields) override;
    /// Shows where the line between two lanes can be taken hold of.
    bool hover(const FieldViewports& fields) override;

  private:
    enum class Drag { None, Pan, Wipe };

    bool press(const InputEvent& event, const FieldViewports& fields);
    void move(const InputEvent& event, const FieldViewports& fields);

    ViewSettings& view_;
    Drag drag_ = Drag::None;
    int button_ = 0;
    std::size_t lane_ = 0;  ///< on whose tile the drag began
    double x_ = 0, y_ = 0;  ///< of the pointer, pixels
};

/// Whether a pixel is near enough to the line between two lanes to take hold of it.
bool on_wipe_line(const FieldViewports& fields, double x, double y);

}  // namespace whorl::app
