#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/charts/measure_tabs.h"
#include "app/ui/widgets.h"

namespace whorl::app {
namespace {

/// Decades below the peak that are shown: what lies lower is rounding.
constexpr double decades = 10;

std::optional<Interval> range_of(const std::vector<LaneSpectrum>& lanes) {
    double peak = 0;
    double least = INFINITY;
    for (const LaneSpectrum& lane : lanes) {
        for (const float e : lane.energy) {
            if (!(e > 0)) continue;
            peak = std::max(peak, static_cast<double>(e));
            least = std::min(least, static_cast<double>(e));
        }
    }
    if (peak <= 0) return {};
    return Interval{std::max(0.5 * least, peak * std::pow(10.0, -decades)), 3 * peak};
}

class SpectrumTab final : public Tab {
  public:
    SpectrumTab(Ui& ui, const RunView& run, MeasureView& view) : ui_(ui), run_(run), view_(view) {}

    void draw() override {
        const Theme& theme = ui_.theme;
        const SessionSnapshot& session = run_.session();
        Spectra& spectra = view_.spectra;
        spectra.follow(session, ImGui::GetTime());
        std::vector<Series> series;
        for (const LaneSpectrum& lane : spectra.lanes()) {
            const auto place =
                std::find(session.ids.begin(), session.ids.end(), lane.id) - session.ids.begin();
            if (place == static_cast<std::ptrdiff_t>(session.ids.size())) continue;  // it was removed
            Series one{run_.names().name(static_cast<std::size_t>(place)),
                       theme.lane(static_cast<int>(place)), lane.energy};
            one.x = lane.k;
            series.push_back(one);
        }
        char title[64];
        std::snprintf(title, sizeof title, "Energy spectrum E(k) · step %ld", spectra.step());
        Plot plot;
        plot.title = series.empty() ? "Energy spectrum E(k)" : title;
        plot.legend = false;
        plot.x_name = "k";
        plot.x_unit = "rad/length";
        plot.log_x = true;
        plot.log_y = true;
        plot.y_range = range_of(spectra.lanes());
        plot.empty_text =
            session.lanes.front().grid().dimensions() == 1 ? "a line has no spectrum" : "in the making";
        plot.size = {0, std::floor(std::min(ImGui::GetContentRegionAvail().y - theme.px(64), theme.px(460)))};
        plot.size.y = std::max(plot.size.y, theme.px(160));
        draw_on_card(ui_, plot, series);
        ui_.log.control("plot=spectrum");
        ImGui::PushFont(theme.small);
        ImGui::PushTextWrapPos(0);
        text(theme.palette.text_dim,
             "How the mean of ½|u|² spreads over wave numbers, length³/time². A dissipative scheme takes the "
             "high "
             "ones first. The slope of 2D turbulence is about k⁻³.");
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
    }

  private:
    Ui& ui_;
    const RunView& run_;
    MeasureView& view_;
};

}  // namespace

std::unique_ptr<Tab> make_spectrum_tab(Ui& ui, const RunView& run, MeasureView& view) {
    return std::make_unique<SpectrumTab>(ui, run, view);
}

}  // namespace whorl::app
