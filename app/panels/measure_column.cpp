#include "app/panels/measure_column.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/panels/widgets.h"
#include "app/plot/plot.h"
#include "app/plot/ticks.h"
#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

/// A curve of a chart.
struct Curve {
    const char* label;
    Track track;
};

/// A plot of the run's history.
struct Chart {
    enum class When { Always, Solved, Exact };  ///< a flow that is solved for; an exact solution

    const char* title;
    const char* unit;
    bool logarithmic;
    When when;
    std::span<const Curve> curves;
};

constexpr Curve total[] = {{"of what was put in", Track::DensityPercent}};
constexpr Curve error[] = {{"L1", Track::L1}, {"L2", Track::L2}, {"L∞", Track::Linf}};
constexpr Curve energy[] = {{"½∫|u|²", Track::KineticEnergy}};
constexpr Curve enstrophy[] = {{"½∫ω²", Track::Enstrophy}};
constexpr Curve divergence[] = {{"before", Track::DivergenceBefore}, {"after", Track::DivergenceAfter}};
constexpr Curve phases[] = {{"total", Track::TotalMs},
                            {"projection", Track::ProjectionMs},
                            {"advection", Track::AdvectionMs},
                            {"forces", Track::ForcesMs}};

constexpr Chart charts[] = {
    {"Error", "", true, Chart::When::Exact, error},
    {"Total smoke", "%", false, Chart::When::Always, total},
    {"Kinetic energy", "", false, Chart::When::Solved, energy},
    {"Enstrophy", "", false, Chart::When::Solved, enstrophy},
    {"Max |∇·u|", "1/time", true, Chart::When::Solved, divergence},
    {"Step time", "ms", false, Chart::When::Always, phases},
};

bool wanted(const Chart& chart, const Snapshot& s) {
    if (chart.when == Chart::When::Exact) return experiment(s.scene.experiment).exact != nullptr;
    if (chart.when == Chart::When::Solved) return experiment(s.scene.experiment).flow == nullptr;
    return true;
}

/// Shares of smoke get a scale that does not blow up rounding; times one that a factorisation now and then
/// does not flatten.
std::optional<Interval> range_of(const Chart& chart, std::span<const float> y) {
    std::vector<float> known(y.begin(), y.end());
    std::erase_if(known, [](float value) { return std::isnan(value); });
    if (known.empty()) return {};
    if (chart.curves.data() == total) {
        const auto [least, most] = std::minmax_element(known.begin(), known.end());
        const double lo = std::min(99.0, static_cast<double>(*least));
        const double hi = std::max(101.0, static_cast<double>(*most));
        const double air = 0.08 * (hi - lo);
        return Interval{lo - air, hi + air};
    }
    if (chart.curves.data() == phases) {
        const auto high = known.begin() + static_cast<long>(0.98 * static_cast<double>(known.size()));
        std::nth_element(known.begin(), high, known.end());
        if (*high > 0) return Interval{0, 1.4 * static_cast<double>(*high)};
    }
    return {};
}

/// A plot on a card that costs nothing to fill.
std::optional<double> draw_card(PanelContext& context, const Plot& plot, std::span<const Series> series) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + ImGui::GetContentRegionAvail().x, low.y + plot.size.y};
    context.slabs.add(*ImGui::GetWindowDrawList(), low, high, context.theme.px(5),
                      context.theme.palette.card);
    Theme bare = context.theme;
    bare.palette.card = 0;
    return draw_plot(bare, plot, series);
}

std::optional<double> draw(PanelContext& context, const Chart& chart, float height) {
    std::vector<Series> series;
    for (const Curve& curve : chart.curves) {
        const ImU32 colour = context.theme.palette.series[series.size()];
        series.push_back({curve.label, colour, context.history.of(curve.track)});
    }
    Plot plot;
    plot.title = chart.title;
    plot.unit = chart.unit;
    plot.x = context.history.steps();
    plot.log_y = chart.logarithmic;
    plot.y_range = range_of(chart, series.front().y);
    plot.marker = context.view.marker;
    if (chart.when == Chart::When::Exact) plot.empty_text = "no exact solution so far";
    plot.size = {0, height};
    return draw_card(context, plot, series);
}

void draw_frame_time(PanelContext& context, float height) {
    const FrameLog& frames = context.frames;
    char title[48];
    std::snprintf(title, sizeof title, "Frame time · %.0f fps", frames.frames_per_second());
    Plot plot;
    plot.title = title;
    plot.unit = "ms";
    plot.x_name = "frame";
    plot.x_first = static_cast<double>(frames.first());
    plot.y_range =
        Interval{0, std::max(25.0, 1.1 * static_cast<double>(*std::max_element(frames.intervals().begin(),
                                                                               frames.intervals().end())))};
    plot.size = {0, height};
    const auto& colours = context.theme.palette.series;
    const Series series[] = {{"frame", colours[0], frames.intervals()}, {"busy", colours[1], frames.work()}};
    draw_card(context, plot, series);
    context.trace.control("plot=frame-time");
}

void figures_line(PanelContext& context) {
    const Measures& m = context.history.last();
    const Theme& theme = context.theme;
    ImGui::PushFont(theme.mono);
    const std::string smoke =
        "Σρ " +
        (m.density_percent == m.density_percent ? figure(m.density_percent, 4) + " %" : std::string("–"));
    text(theme.palette.text, smoke);
    ImGui::SameLine(0, theme.px(18));
    text(theme.palette.text, "CFL " + figure(m.cfl, 3));
    const std::string largest = "max|∇·u| " + figure(m.divergence_after, 2);
    ImGui::SameLine(0, theme.px(18));
    if (ImGui::CalcTextSize(largest.c_str()).x <= ImGui::GetContentRegionAvail().x) {
        text(theme.palette.text, largest);
    } else {
        ImGui::NewLine();
    }
    ImGui::PopFont();
}

}  // namespace

void draw_measure_column(PanelContext& context) {
    const Theme& theme = context.theme;
    ImGui::PushFont(theme.title);
    ImGui::TextUnformatted("Measures");
    ImGui::PopFont();
    ImGui::Separator();
    figures_line(context);
    ImGui::BeginChild("plots", {0, 0}, false, ImGuiWindowFlags_None);
    const auto count = 1 + std::count_if(std::begin(charts), std::end(charts), [&](const Chart& chart) {
                           return wanted(chart, context.snapshot());
                       });
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const float room = ImGui::GetContentRegionAvail().y / static_cast<float>(count) - gap;
    const float height = std::floor(std::clamp(room, theme.px(118), theme.px(320)));
    std::optional<double> hovered;
    for (const Chart& chart : charts) {
        if (!wanted(chart, context.snapshot())) continue;
        const auto x = draw(context, chart, height);
        context.trace.control("plot=" + std::string(chart.title));
        if (x) hovered = x;
    }
    if (!context.frames.intervals().empty()) draw_frame_time(context, height);
    context.view.marker = hovered;
    ImGui::EndChild();
}

}  // namespace whorl::app
