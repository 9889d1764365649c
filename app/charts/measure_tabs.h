// The pages of the measures' column, one file each.
#pragma once

#include <span>
#include <vector>

#include "app/charts/panel_context.h"
#include "app/figure/sheet.h"
#include "app/plot/plot.h"

namespace whorl::app {

/// The measures over steps: several curves of one lane, or one curve of each of several lanes.
void draw_plots_tab(PanelContext&);
/// The kinetic-energy spectrum of every lane.
void draw_spectrum_tab(PanelContext&);
/// Who gave and took energy or enstrophy in the selected lane, and every lane's effective viscosity.
void draw_budget_tab(PanelContext&);
/// The present values of every lane.
void draw_table_tab(PanelContext&);

/// A plot on a card that costs nothing to fill.
std::optional<double> draw_on_card(PanelContext& context, const Plot& plot, std::span<const Series> series);

/// What the plots tab shows up to a step, for a picture. Times are left out: they are the machine's.
std::vector<SheetPlot> plots_of(const History& history, const SessionSnapshot& session,
                                const MeasureView& view);

/// Whether lanes have errors: there is an exact solution, or a lane to be measured against.
bool has_errors(const SessionSnapshot& session);

}  // namespace whorl::app
