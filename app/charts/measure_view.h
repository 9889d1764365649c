// What a person has chosen to see of the measures.
#pragma once

#include <optional>

#include "app/charts/spectra.h"
#include "app/run/history.h"

namespace whorl::app {

enum class MeasureTab { Plots, Spectrum, Budget, Table };

struct MeasureView {
    MeasureTab tab = MeasureTab::Plots;
    const Measure* norm = &measures().find("L2");  ///< of the errors, where each lane has one curve
    std::size_t budget = 0;        ///< the one that is shown, of charts_of(Page::BudgetShares)
    std::optional<double> marker;  ///< x of the plot sample under the pointer, a hairline in the others
    Spectra spectra;
};

}  // namespace whorl::app
