// The list of measures.
#include <limits>

#include "core/measure/measure.h"
#include "core/scene/phase.h"

namespace whorl {
namespace {

/// A member of the step's record, or of a member of it.
template <class T>
auto of(T Measures::*member) {
    return [member](const Measures& m, const Sums&) { return static_cast<double>(m.*member); };
}
template <class Part, class T>
auto of(Part Measures::*part, T Part::*member) {
    return [part, member](const Measures& m, const Sums&) { return static_cast<double>(m.*part.*member); };
}

constexpr Tables only_run{.run = true, .compare = false, .experiment = false};
constexpr Tables no_table{.run = false, .compare = false, .experiment = false};
constexpr Tables only_timing{.run = false, .compare = false, .experiment = false, .timing = true};
const Plotting no_plot{.page = Page::None};
const Column no_column{.group = ""};

std::vector<Measure> smoke() {
    return {
        {.key = "density_percent",
         .title = "Total smoke",
         .unit = "%",
         .help = "Total smoke: what is left of what was put in",
         .source = "thesis eq. 5.5",
         .value = [](const Measures& m, const Sums&) { return m.density_percent(); },
         .best = Best::NearestHundred,
         .plot = {.label = "of what was put in", .scale = Scale::Percent},
         .column = {"Smoke", "total, %"},
         .headline = {"Σρ", 4, " %"}},
    };
}

/// The totals of further scalars that are counted.
std::vector<Measure> further_totals() {
    std::vector<Measure> all;
    for (std::size_t k = 2; k < scalar_count(); ++k) {
        const FieldInfo& info = scalar(k).info();
        if (!info.counted) continue;
        const std::string title(info.title);
        all.push_back({.key = std::string(info.key) + "_percent",
                       .title = "Total of " + title,
                       .unit = "%",
                       .help = title + ": what is left of what was put in",
                       .source = "thesis eq. 5.5",
                       .value = [k](const Measures& m, const Sums&) { return m.percent_of(k); },
                       .best = Best::NearestHundred,
                       .plot = {.label = "of what was put in", .scale = Scale::Percent},
                       .column = {title, "total, %"}});
    }
    return all;
}

std::vector<Measure> flow() {
    return {
        {.key = "kinetic_energy",
         .title = "Kinetic energy",
         .unit = "length⁴/time²",
         .help = "Kinetic energy, ½∫|u|²",
         .needs = Needs::SolvedFlow,
         .value = of(&Measures::kinetic_energy),
         .tables = {.experiment = false},
         .plot = {.label = "½∫|u|²", .unit = false},
         .column = {"Flow", "energy"}},
        {.key = "enstrophy",
         .title = "Enstrophy",
         .unit = "length²/time²",
         .help = "½∫ω²",
         .needs = Needs::SolvedFlow,
         .value = of(&Measures::enstrophy),
         .tables = {.experiment = false},
         .plot = {.label = "½∫ω²", .unit = false},
         .column = {"Flow", "enstrophy"}},
        {.key = "cfl",
         .title = "CFL number",
         .unit = "",
         .help = "The largest speed, in cells a step",
         .value = of(&Measures::cfl),
         .tables = no_table,
         .plot = no_plot,
         .column = no_column,
         .headline = {"CFL", 3, ""}},
        {.key = "max_divergence",
         .aliases = {"divergence_after"},
         .title = "Largest divergence",
         .unit = "1/time",
         .help = "Largest |∇·u| after the projection",
         .needs = Needs::SolvedFlow,
         .value = of(&Measures::divergence_after),
         .tables = only_run,
         .plot = {.chart = "Max |∇·u|", .label = "after", .scale = Scale::Logarithmic},
         .column = no_column,
         .headline = {"max|∇·u|", 2, ""}},
    };
}

std::vector<Measure> extrema_and_limiters() {
    return {
        {.key = "min",
         .title = "Smallest density",
         .unit = "",
         .help = "Smallest density",
         .value = of(&Measures::min_density),
         .plot = {.chart = "Density",
                  .label = "min",
                  .colour = 1,
                  .scale = Scale::Density,
                  .lanes_chart = "Smallest density"},
         .column = {"Smoke", "min"}},
        {.key = "max",
         .title = "Largest density",
         .unit = "",
         .help = "Largest density",
         .value = of(&Measures::max_density),
         .plot =
             {.chart = "Density", .label = "max", .scale = Scale::Density, .lanes_chart = "Largest density"},
         .column = {"Smoke", "max"}},
        {.key = "limited_density",
         .title = "Limited nodes of smoke",
         .unit = "",
         .help = "Nodes at which a limiter, or a clamped interpolation, changed the density in the last step",
         .needs = Needs::LimiterMasks,
         .value = of(&Measures::limited, &LimiterCounts::density),
         .tables = no_table,
         .plot = {.chart = "Limited nodes", .label = "smoke", .lanes_chart = "Limited nodes of smoke"},
         .column = no_column},
        {.key = "limited_velocity",
         .title = "Limited faces",
         .unit = "",
         .help =
             "Faces of both directions at which a limiter, or a clamped interpolation, changed the velocity "
             "in the last step",
         .needs = Needs::LimiterMasks,
         .value = of(&Measures::limited, &LimiterCounts::velocity),
         .tables = no_table,
         .plot = {.chart = "Limited nodes", .label = "velocity", .colour = 1},
         .column = no_column},
    };
}

Measure error(std::string key, std::string label, int colour, double Errors::*norm, std::string unit,
              std::string help, std::string source) {
    std::string alias = key;
    alias.front() = 'l';
    return {.key = std::move(key),
            .aliases = {std::move(alias)},
            .title = "Error " + label,
            .unit = std::move(unit),
            .help = std::move(help),
            .source = std::move(source),
            .needs = Needs::Reference,
            .value = of(&Measures::errors, norm),
            .best = Best::Least,
            .plot = {.chart = "Error",
                     .label = label,
                     .colour = colour,
                     .scale = Scale::Logarithmic,
                     .unit = false,
                     .lanes_chart = "Error " + label},
            .column = {"Error", label}};
}

std::vector<Measure> errors() {
    return {
        error("L1", "L1", 0, &Errors::L1, "length²",
              "Mean error against the exact solution or the reference lane", "thesis eq. 5.4"),
        error("L2", "L2", 1, &Errors::L2, "length", "Root of the mean square error", "thesis eq. 5.6"),
        error("Linf", "L∞", 2, &Errors::Linf, "", "Largest error", "thesis eq. 5.7"),
    };
}

std::vector<Measure> dissipation_and_projection() {
    return {
        {.key = "effective_viscosity",
         .title = "Effective viscosity",
         .unit = "length²/time",
         .help = "Effective viscosity of the last step's advection, length²/time",
         .needs = Needs::SolvedFlow,
         .value = of(&Measures::effective_viscosity),
         .best = Best::NearestZero,
         .mean = Mean::OverSteps,
         .tables = {.run = false, .experiment = false},
         .plot = {.page = Page::Budget},
         .column = {"Flow", "visc."}},
        {.key = "divergence_before",
         .title = "Largest divergence before",
         .unit = "1/time",
         .help = "Largest |∇·u| before the projection",
         .needs = Needs::SolvedFlow,
         .value = of(&Measures::divergence_before),
         .tables = no_table,
         .plot = {.chart = "Max |∇·u|", .label = "before", .colour = 1, .scale = Scale::Logarithmic},
         .column = no_column},
        {.key = "relative_divergence",
         .title = "Relative divergence",
         .unit = "",
         .help = "Largest |∇·u| h over the largest speed, after the projection",
         .needs = Needs::SolvedFlow,
         .value = of(&Measures::relative_divergence),
         .tables = no_table,
         .plot = no_plot,
         .column = no_column},
        {.key = "removed_divergence",
         .title = "Removed mean divergence",
         .unit = "1/time",
         .help = "Mean ∇·u that the projection took out of a closed component",
         .needs = Needs::SolvedFlow,
         .value = of(&Measures::removed_mean),
         .tables = no_table,
         .plot = no_plot,
         .column = no_column},
    };
}

/// What a phase added to energy or enstrophy in the last step.
Measure budget(const Phase& of_phase, const char* quantity, const char* shared, const char* unit,
               double PhaseShare::*share) {
    const std::string phase(of_phase.key);
    std::string lower = quantity;
    lower.front() = static_cast<char>(lower.front() + ('a' - 'A'));
    return {.key = lower + "_by_" + phase,
            .title = std::string(quantity) + " by " + phase,
            .unit = unit,
            .help = "What " + phase + " gave of " + shared + ", in the last step; below 0 it took",
            .needs = Needs::SolvedFlow,
            .value = [phase, share](const Measures& m, const Sums&) { return m.phase(phase).*share; },
            .tables = no_table,
            .plot = {.page = Page::BudgetShares,
                     .chart = quantity,
                     .label = phase,
                     .colour = of_phase.curves->in_budget,
                     .shared = shared},
            .column = no_column};
}

std::vector<Measure> budgets() {
    std::vector<Measure> all;
    for (const Phase* phase : phases().all()) {
        if (phase->curves)
            all.push_back(
                budget(*phase, "Energy", "kinetic energy, ½∫|u|²", "length⁴/time²", &PhaseShare::energy));
    }
    for (const Phase* phase : phases().all()) {
        if (phase->curves)
            all.push_back(
                budget(*phase, "Enstrophy", "enstrophy, ½∫ω²", "length²/time²", &PhaseShare::enstrophy));
    }
    return all;
}

/// @param row  in `whorl run --timing`
Measure time(std::string key, const std::string& row, int colour, std::string help,
             std::function<double(const Measures&, const Sums&)> value) {
    return {.key = std::move(key),
            .title = "Time of " + row,
            .unit = "ms",
            .help = std::move(help),
            .value = std::move(value),
            .best = Best::Least,
            .mean = Mean::Median,
            .timing = true,
            .tables = only_timing,
            .plot = {.chart = "Step time", .label = row, .colour = colour, .scale = Scale::Milliseconds},
            .column = no_column};
}

std::vector<Measure> times() {
    std::vector<Measure> all;
    for (const Phase* of_phase : phases().all()) {
        if (!of_phase->curves) continue;
        const std::string phase(of_phase->key);
        all.push_back(time(phase + "_ms", phase, of_phase->curves->in_times,
                           "Milliseconds that " + phase + " took",
                           [phase](const Measures& m, const Sums&) { return m.phase(phase).ms; }));
    }
    all.push_back(time("step_ms", "total", 0, "Milliseconds that a step took", of(&Measures::step_ms)));
    all.back().title = "Step time";
    all.back().column = {"Cost", "ms a step"};
    return all;
}

/// Within the projection.
std::vector<Measure> solver() {
    std::vector<Measure> all{
        time("pressure_setup_ms", "pressure_setup", 0, "Milliseconds that the pressure solver's set-up took",
             of(&Measures::pressure, &SolveReport::setup_ms)),
        time("pressure_solve_ms", "pressure_solve", 0, "Milliseconds that the pressure solve took",
             of(&Measures::pressure, &SolveReport::solve_ms)),
        {.key = "pressure_iterations",
         .title = "Pressure iterations",
         .unit = "",
         .help = "Iterations of the pressure solver",
         .needs = Needs::SolvedFlow,
         .value = of(&Measures::pressure, &SolveReport::iterations),
         .tables = only_timing,
         .column = no_column},
        {.key = "pressure_residual",
         .title = "Pressure residual",
         .unit = "",
         .help = "What the pressure solver left of the right-hand side",
         .needs = Needs::SolvedFlow,
         .value = of(&Measures::pressure, &SolveReport::residual),
         .tables = only_timing,
         .column = no_column},
    };
    for (Measure& measure : all) {
        measure.plot = no_plot;
        measure.plot.label = measure.key.substr(0, measure.key.find("_ms"));
    }
    return all;
}

Registry<Measure> made() {
    static const std::vector<Measure> groups[] = {
        smoke(), flow(),   extrema_and_limiters(), errors(), dissipation_and_projection(), budgets(),
        times(), solver(), further_totals()};
    Registry<Measure> registry("measure", {});
    for (const std::vector<Measure>& group : groups) {
        for (const Measure& measure : group) registry.add(measure);
    }
    return registry;
}

}  // namespace

double Measure::of(const Measures& step) const {
    if (!row) return value(step, {});
    for (const Reduced& reduced : step.reduced) {
        if (reduced.measure == this) return value(step, reduced.sums);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

Registry<Measure>& measures() {
    static Registry<Measure> registry = made();
    return registry;
}

}  // namespace whorl
