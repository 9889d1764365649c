#include "app/cli/run_tables.h"

#include <algorithm>
#include <span>
#include <utility>
#include <variant>

namespace whorl::app {
namespace {

constexpr const char* columns = "step,time,density_percent,kinetic_energy,enstrophy,max_divergence,min,max";

/// @param values  one or more
double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

RowNames::RowNames(const Recording& recording) : several_(recording.setup.lanes.size() > 1) {
    for (const Stamped& stamped : recording.commands) {
        const auto* arrange = std::get_if<Arrange>(&stamped.command);
        several_ = several_ || (arrange != nullptr && arrange->lanes.size() > 1);
    }
}

const std::string& RowNames::of(const Session& session, std::size_t k) {
    const auto [lane, is_new] = names_.try_emplace(session.id(k));
    if (is_new) lane->second = unused(titles(session.setup())[k]);
    return lane->second;
}

std::string RowNames::unused(const std::string& title) const {
    const auto used = [&](const std::string& name) {
        return std::any_of(names_.begin(), names_.end(), [&](const auto& n) { return n.second == name; });
    };
    std::string name = title;
    for (int n = 2; used(name); ++n) name = title + " (" + std::to_string(n) + ")";
    return name;
}

Rows::Rows(const std::string& file, RowNames& names, bool limited)
    : names_(names),
      limited_(limited),
      series_(file, std::string(names.several() ? "lane," : "") + columns +
                        (limited ? ",limited_density,limited_velocity" : "")) {}

void Rows::add(const Session& session) {
    for (std::size_t k = 0; k < session.lane_count(); ++k) {
        const Measures& m = session.measures(k);
        const double row[] = {static_cast<double>(session.step_number()),
                              m.time,
                              m.density_percent,
                              m.kinetic_energy,
                              m.enstrophy,
                              m.divergence_after,
                              m.min_density,
                              m.max_density,
                              m.limited.density,
                              m.limited.velocity};
        const std::span<const double> shown = std::span(row).first(std::size(row) - (limited_ ? 0 : 2));
        if (names_.several()) {
            series_.row({names_.of(session, k)}, shown);
        } else {
            series_.row(shown);
        }
    }
}

void Timings::add(const Session& session) {
    for (std::size_t k = 0; k < session.lane_count(); ++k) {
        Lane& lane = lanes_[session.id(k)];
        if (lane.steps.empty()) lane.name = names_.of(session, k);
        lane.steps.push_back({session.measures(k).ms, session.measures(k).pressure});
    }
}

void Timings::write(const std::string& file) const {
    Series series(file, names_.several() ? "lane,phase,median_ms" : "phase,median_ms");
    for (const auto& entry : lanes_) {
        const Lane& lane = entry.second;
        const auto row = [&](std::string_view phase, auto&& figure) {
            std::vector<double> values(lane.steps.size());
            std::transform(lane.steps.begin(), lane.steps.end(), values.begin(), figure);
            const double value = median(std::move(values));
            if (names_.several()) {
                series.row({lane.name, phase}, {&value, 1});
            } else {
                series.row({phase}, {&value, 1});
            }
        };
        row("forces", [](const Step& s) { return s.ms.forces; });
        row("projection", [](const Step& s) { return s.ms.projection; });
        row("advection", [](const Step& s) { return s.ms.advection; });
        row("total", [](const Step& s) { return s.ms.total; });
        // Within the projection; the last two are no times.
        row("pressure_setup", [](const Step& s) { return s.pressure.setup_ms; });
        row("pressure_solve", [](const Step& s) { return s.pressure.solve_ms; });
        row("pressure_iterations", [](const Step& s) { return s.pressure.iterations; });
        row("pressure_residual", [](const Step& s) { return s.pressure.residual; });
    }
    series.finish();
}

}  // namespace whorl::app
