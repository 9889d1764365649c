#include "app/charts/plots_csv.h"

#include "core/base/csv.h"

namespace whorl::app {
namespace {

struct Column {
    const char* name;
    Track track;
};

constexpr Column columns[] = {{"density_percent", Track::DensityPercent},
                              {"kinetic_energy", Track::KineticEnergy},
                              {"enstrophy", Track::Enstrophy},
                              {"min", Track::MinDensity},
                              {"max", Track::MaxDensity},
                              {"divergence_before", Track::DivergenceBefore},
                              {"divergence_after", Track::DivergenceAfter},
                              {"l1", Track::L1},
                              {"l2", Track::L2},
                              {"linf", Track::Linf},
                              {"effective_viscosity", Track::EffectiveViscosity},
                              {"energy_by_forces", Track::EnergyByForces},
                              {"energy_by_projection", Track::EnergyByProjection},
                              {"energy_by_advection", Track::EnergyByAdvection},
                              {"enstrophy_by_forces", Track::EnstrophyByForces},
                              {"enstrophy_by_projection", Track::EnstrophyByProjection},
                              {"enstrophy_by_advection", Track::EnstrophyByAdvection},
                              {"limited_density", Track::LimitedDensity},
                              {"limited_velocity", Track::LimitedVelocity},
                              {"step_ms", Track::TotalMs}};

/// Curves are kept in single precision.
std::string number(float value) {
    return csv_number(static_cast<double>(value), 7);
}

}  // namespace

std::string plots_csv(const std::vector<CsvLane>& lanes) {
    std::string out = "step,time,lane,title";
    for (const Column& column : columns) out += "," + std::string(column.name);
    out += '\n';
    for (std::size_t k = 0; k < lanes.size(); ++k) {
        const LaneHistory& lane = lanes[k].history;
        const std::string name = "," + std::to_string(k + 1) + "," + csv_text(lanes[k].title);
        for (std::size_t row = 0; row < lane.steps.size(); ++row) {
            out += std::to_string(static_cast<long>(lane.steps[row])) + ",";
            out += number(lane.of(Track::Time)[row]);
            out += name;
            for (const Column& column : columns) {
                out += ',' + number(lane.of(column.track)[row]);
            }
            out += '\n';
        }
    }
    return out;
}

}  // namespace whorl::app
