// From the pointer's path over the field to strokes of the brush.
#pragma once

#include <vector>

#include "app/run/run_control.h"
#include "app/run/tool.h"

namespace whorl::app {

/// A drag in the making. Every position that the pointer went through becomes a segment, so that quick
/// strokes leave a continuous trail.
class BrushTool final : public Tool {
  public:
    explicit BrushTool(RunControl& run) : run_(run) {}

    /// Begins a drag if a press falls on a field, follows it in that field's coordinates, and ends it. The
    /// wheel sets the brush's radius.
    bool take(const InputEvent& event, const FieldViewports& fields) override;
    /// Sends what the drag has done since the last frame. Held still, it goes on emitting while the run
    /// plays.
    void end_frame() override;

  private:
    enum class Mode { None, Smoke, Push, Paint, Erase };

    void send_smoke();
    void send_obstacle();

    RunControl& run_;
    Mode mode_ = Mode::None;
    int button_ = 0;
    std::size_t lane_ = 0;          ///< on whose field the drag began
    bool ended_ = false;            ///< released since the last frame
    bool fresh_ = false;            ///< pressed since the last frame
    std::vector<WorldPoint> path_;  ///< from where the last frame ended
    double last_time_ = 0;          ///< of the run, when strokes were last sent
};

/// The wheel's new radius of the brush: a tenth more or less a notch, round, within the parameter's range.
double wheel_radius(double radius, double notches);

}  // namespace whorl::app
