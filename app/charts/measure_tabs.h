// The pages of the measures' column, one file each.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "app/charts/measure_view.h"
#include "app/figure/sheet.h"
#include "app/plot/plot.h"
#include "app/run/run_view.h"
#include "app/ui/frame_log.h"
#include "app/ui/ui.h"

namespace whorl::app {

class Tab {
  public:
    virtual ~Tab() = default;
    /// Fills the current ImGui window.
    virtual void draw() = 0;
};

/// The measures over steps: several curves of one lane, or one curve of each of several lanes; and the time
/// of the window's frames.
std::unique_ptr<Tab> make_plots_tab(Ui&, const RunView&, const History&, const FrameLog&, MeasureView&);
/// The kinetic-energy spectrum of every lane.
std::unique_ptr<Tab> make_spectrum_tab(Ui&, const RunView&, MeasureView&);
/// What phases gave and took of energy or enstrophy in the selected lane, and every lane's effective
/// viscosity.
std::unique_ptr<Tab> make_budget_tab(Ui&, const RunView&, const History&, MeasureView&);
/// The present values of every lane.
std::unique_ptr<Tab> make_table_tab(Ui&, const RunView&, const History&);

/// A plot on a card that costs nothing to fill.
std::optional<double> draw_on_card(Ui& ui, const Plot& plot, std::span<const Series> series);

/// What the plots tab shows up to a step, for a picture. Times are left out: they are the machine's.
std::vector<SheetPlot> plots_of(const History& history, const SessionSnapshot& session,
                                const MeasureView& view);

/// Whether lanes have errors: there is an exact solution, or a lane to be measured against.
bool has_errors(const SessionSnapshot& session);

}  // namespace whorl::app
