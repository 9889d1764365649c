// The right column: the run's measures as plots over steps, and the window's own frame time.
#pragma once

#include <memory>
#include <vector>

#include "app/charts/measure_tabs.h"
#include "app/run/right_column.h"
#include "app/run/run_control.h"
#include "app/run/services.h"

namespace whorl::app {

/// Those that a tab shows and that steps sum up only on demand. Limiters are watched where the view asks.
std::vector<const Measure*> measures_in_sight(MeasureTab tab);

class MeasureColumn {
  public:
    MeasureColumn(const Services& services, MeasureView& view);

    /// Fills the current ImGui window.
    void draw();

  private:
    /// Of the selected lane, as many figures as there is room for.
    void figures_line();
    /// One legend for all plots: a lane's colour and title; a click selects the lane.
    void lane_legend();
    void tab_chips();

    Ui& ui_;
    RunControl& run_;
    RightColumn& right_column_;
    MeasureView& view_;
    std::vector<std::unique_ptr<Tab>> tabs_;
};

}  // namespace whorl::app
