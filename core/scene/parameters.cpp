#include "core/scene/parameters.h"

#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/suggest.h"
#include "core/pressure/solver.h"
#include "core/scene/step_order.h"

namespace whorl {
namespace {

using Kind = Parameter::Kind;
using Group = Parameter::Group;
using Table = std::vector<Parameter>;

// ---- rows of a kind
// ------------------------------------------------------------------------------------------

struct Words {
    std::string key, label, unit, help, source;
};
struct Range {
    double min, max, slider_min, slider_max;
    bool logarithmic = false;
};

Parameter row(Words words, Group group, Kind kind, Range range) {
    Parameter p;
    p.key = std::move(words.key);
    p.label = std::move(words.label);
    p.unit = std::move(words.unit);
    p.help = std::move(words.help);
    p.source = std::move(words.source);
    p.group = group;
    p.kind = kind;
    p.min = range.min;
    p.max = range.max;
    p.slider_min = range.slider_min;
    p.slider_max = range.slider_max;
    p.logarithmic = range.logarithmic;
    return p;
}

/// A row for a number or truth that `member` finds in a scene.
template <class Member>
Parameter value_row(Words words, Group group, Range range, Member member) {
    using T = std::remove_reference_t<std::invoke_result_t<Member, Scene&>>;
    const Kind kind = std::is_same_v<T, bool> ? Kind::Switch
                      : std::is_integral_v<T> ? Kind::Integer
                                              : Kind::Number;
    Parameter p = row(std::move(words), group, kind, range);
    p.get = [member](const Scene& s) { return static_cast<double>(member(const_cast<Scene&>(s))); };
    p.set = [member](Scene& s, double v) { member(s) = static_cast<T>(v); };
    return p;
}

/// A row for a choice of an entry of a registry.
template <class Entry, class Member>
Parameter entry_row(Words words, Group group, Member member) {
    const double last = static_cast<double>(Entry::list().all().size() - 1);
    Parameter p = row(std::move(words), group, Kind::Choice, {0, last, 0, last});
    for (const Entry* entry : Entry::list().all()) p.choices.push_back(entry->info);
    p.get = [member](const Scene& s) { return static_cast<double>(member(const_cast<Scene&>(s)).index()); };
    p.set = [member](Scene& s, double v) { member(s) = Id<Entry>::at(static_cast<std::size_t>(v)); };
    return p;
}

/// A row for a choice that a scene holds as an index.
Parameter index_row(Words words, Group group, std::vector<SchemeInfo> choices, std::size_t Scene::*member) {
    const double last = static_cast<double>(choices.size() - 1);
    Parameter p = row(std::move(words), group, Kind::Choice, {0, last, 0, last});
    p.choices = std::move(choices);
    p.get = [member](const Scene& s) { return static_cast<double>(s.*member); };
    p.set = [member](Scene& s, double value) { s.*member = static_cast<std::size_t>(value); };
    return p;
}

/// Adds a row of a scheme set three times: for both sets, for the velocity's and for the scalars'.
template <class MakeRow>
void add_scheme_rows(Table& table, const MakeRow& make) {
    Parameter velocity = make([](Scene& s) -> SchemeSet& { return s.velocity; });
    Parameter scalars = make([](Scene& s) -> SchemeSet& { return s.scalars; });
    Parameter both = scalars;
    both.set = [v = velocity.set, s = scalars.set](Scene& scene, double value) {
        v(scene, value);
        s(scene, value);
    };
    for (Parameter* one : {&velocity, &scalars}) {
        one->set = [set = one->set](Scene& scene, double value) {
            set(scene, value);
            scene.linked = scene.velocity == scene.scalars && scene.linked;
        };
    }
    velocity.key = "velocity." + velocity.key;
    scalars.key = "scalars." + scalars.key;
    table.push_back(std::move(both));
    table.push_back(std::move(velocity));
    table.push_back(std::move(scalars));
}

// ---- the rows
// ------------------------------------------------------------------------------------------------

Parameter sides_row() {
    const auto all = NamedSides::list().all();
    const double last = static_cast<double>(all.size() - 1);
    Parameter p = row({"sides", "Sides", "", "What closes the domain.", ""}, Group::Domain, Kind::Choice,
                      {0, last, 0, last});
    for (const NamedSides* each : all) p.choices.push_back(each->info);
    p.get = [](const Scene& s) { return static_cast<double>(NamedSides::list().index(named(s.sides))); };
    p.set = [](Scene& s, double v) {
        s.sides = NamedSides::list().all()[static_cast<std::size_t>(v)]->sides;
    };
    return p;
}

void add_domain(Table& t) {
    t.push_back(value_row(
        {"resolution", "Resolution", "cells", "Cells along the width. The running fields are resampled.", ""},
        Group::Domain, {4, 2048, 16, 512}, [](Scene& s) -> int& { return s.resolution; }));
    t.push_back(value_row({"width", "Width", "length", "Width of the domain.", ""}, Group::Domain,
                          {1, 1000, 10, 100}, [](Scene& s) -> double& { return s.width; }));
    t.push_back(value_row({"height", "Height", "length", "Height of the domain.", ""}, Group::Domain,
                          {1, 1000, 10, 100}, [](Scene& s) -> double& { return s.height; }));
    t.push_back(sides_row());
}

void add_time(Table& t) {
    t.push_back(value_row(
        {"dt", "Δt", "time", "Time step. Semi-Lagrangian schemes are stable at any.", "thesis alg. 2.1"},
        Group::Time, {1e-6, 100, 0.001, 0.2, true}, [](Scene& s) -> double& { return s.dt; }));
    t.push_back(value_row({"steps", "Steps", "steps", "Steps of a run without a window.", ""}, Group::Time,
                          {0, 1e7, 60, 1200}, [](Scene& s) -> int& { return s.steps; }));
    std::vector<SchemeInfo> orders;
    for (const StepOrder* order : step_orders().all()) orders.push_back(order->info);
    t.push_back(index_row({"order", "Step order", "", "The order of forces, projection and advection.",
                           "thesis alg. 2.1; Fedkiw et al. eq. 14"},
                          Group::Time, std::move(orders), &Scene::order));
}

// NOLINTNEXTLINE(readability-function-size): a table
void add_schemes(Table& t) {
    Parameter linked = value_row({"linked", "Link velocity and scalars", "",
                                  "One choice of schemes moves velocity, density and temperature alike.", ""},
                                 Group::Schemes, {0, 1, 0, 1}, [](Scene& s) -> bool& { return s.linked; });
    linked.set = [](Scene& s, double value) {
        s.linked = value != 0;
        if (s.linked) s.velocity = s.scalars;
    };
    t.push_back(std::move(linked));
    add_scheme_rows(t, [](auto set) {
        return entry_row<Advector>(
            {"advector", "Advector", "", "How quantities move with the flow.", "thesis ch. 3-4"},
            Group::Schemes, [set](Scene & s) -> auto& { return set(s).advector; });
    });
    add_scheme_rows(t, [](auto set) {
        return entry_row<BaseScheme>(
            {"base", "Base step", "", "The step A that MacCormack and BFECC are built on.",
             "thesis sec. 3.2, 5.5"},
            Group::Schemes, [set](Scene & s) -> auto& { return set(s).base; });
    });
    add_scheme_rows(t, [](auto set) {
        return entry_row<Interpolation>(
            {"interpolation", "Interpolation", "", "How a value between nodes is found.",
             "thesis sec. 3.1, app. A"},
            Group::Schemes, [set](Scene & s) -> auto& { return set(s).interpolation; });
    });
    add_scheme_rows(t, [](auto set) {
        return value_row({"clamped", "Clamp interpolation", "",
                          "Cuts interpolated values to those of the enclosing nodes.", "thesis eq. 3.8"},
                         Group::Schemes, {0, 1, 0, 1}, [set](Scene& s) -> bool& { return set(s).clamped; });
    });
    add_scheme_rows(t, [](auto set) {
        return entry_row<AxisOrder>(
            {"axis-order", "Axis order", "", "Which axis a cubic interpolates along first.",
             "thesis sec. 3.1"},
            Group::Schemes, [set](Scene & s) -> auto& { return set(s).axis_order; });
    });
    add_scheme_rows(t, [](auto set) {
        return entry_row<Tracer>(
            {"tracer", "Tracer", "", "How departure points are found.", "thesis eq. 3.3-3.5"},
            Group::Schemes, [set](Scene & s) -> auto& { return set(s).tracer; });
    });
    add_scheme_rows(t, [](auto set) {
        return entry_row<Limiter>(
            {"limiter", "Limiter", "", "What MacCormack, BFECC and ASLAM do about new extrema.",
             "thesis sec. 3.2, eq. 3.8"},
            Group::Schemes, [set](Scene & s) -> auto& { return set(s).limiter; });
    });
    add_scheme_rows(t, [](auto set) {
        return value_row({"zeta", "ζ", "", "Parametric size of the stencil; 0 is plain semi-Lagrangian.",
                          "thesis sec. 4.1"},
                         Group::Particles, {0, SchemeSet::max_zeta, 0, SchemeSet::max_zeta},
                         [set](Scene& s) -> int& { return set(s).zeta; });
    });
    add_scheme_rows(t, [](auto set) {
        return entry_row<WeightKernel>(
            {"weights", "Weights", "", "How much each particle counts.", "thesis eq. 4.4-4.9"},
            Group::Particles, [set](Scene & s) -> auto& { return set(s).weights; });
    });
    add_scheme_rows(t, [](auto set) {
        return entry_row<StencilShape>(
            {"stencil", "Stencil", "", "Where the particles of a node start.", "thesis table 4.1, fig. 4.2"},
            Group::Particles, [set](Scene & s) -> auto& { return set(s).stencil; });
    });
    t.push_back(value_row({"seed", "Seed", "", "Seed of the jittered stencil.", ""}, Group::Particles,
                          {0, 1e9, 0, 100}, [](Scene& s) -> std::uint64_t& { return s.seed; }));
}

void add_forces(Table& t) {
    t.push_back(
        value_row({"alpha", "α  weight", "acceleration/density", "Dense smoke sinks.", "Fedkiw et al. eq. 4"},
                  Group::Forces, {-1000, 1000, 0, 10}, [](Scene& s) -> double& { return s.alpha; }));
    t.push_back(value_row(
        {"beta", "β  lift of heat", "acceleration/degree", "Warm smoke rises.", "Fedkiw et al. eq. 4"},
        Group::Forces, {-1000, 1000, 0, 0.5}, [](Scene& s) -> double& { return s.beta; }));
    t.push_back(
        value_row({"ambient", "T ambient", "degrees", "Temperature of still air.", "Fedkiw et al. eq. 4"},
                  Group::Forces, {-1000, 1000, -50, 50}, [](Scene& s) -> double& { return s.ambient; }));
    t.push_back(value_row({"confinement", "ε  confinement", "",
                           "Vorticity confinement: a force that winds up vortices. It adds detail; it does "
                           "not undo dissipation.",
                           "Fedkiw et al. eq. 11-13"},
                          Group::Forces, {0, 1000, 0, 5}, [](Scene& s) -> double& { return s.confinement; }));
}

void add_pressure(Table& t) {
    std::vector<SchemeInfo> solvers;
    for (const PressureSolverEntry& entry : pressure_solvers()) solvers.push_back(entry.info);
    t.push_back(
        index_row({"pressure", "Solver", "", "How the pressure equation is solved.", "thesis sec. 2.2"},
                  Group::Pressure, std::move(solvers), &Scene::pressure));
    t.push_back(value_row({"tolerance", "Tolerance", "", "Where an iterative pressure solver stops.", ""},
                          Group::Pressure, {1e-14, 1, 1e-8, 1e-2, true},
                          [](Scene& s) -> double& { return s.tolerance; }));
}

void add_brush(Table& t) {
    t.push_back(
        value_row({"brush.radius", "Radius", "length", "Radius of the brush; the wheel sets it too.", ""},
                  Group::Brush, {0.1, 100, 0.5, 10}, [](Scene& s) -> double& { return s.brush.radius; }));
    for_sources([&](FieldId id) {
        const Source& source = *id.info().source;
        const std::string title(id.info().title);
        t.push_back(value_row({"brush." + std::string(id.info().key), title, std::string(id.info().unit),
                               title + " that a stroke brings smoke up to.", ""},
                              Group::Brush,
                              {source.least, source.most, source.slider_least, source.slider_most},
                              [id](Scene& s) -> double& { return s.brush.amounts.at(id); }));
    });
    t.push_back(
        value_row({"brush.push", "Push", "", "Share of the mouse's velocity that the fluid takes.", ""},
                  Group::Brush, {0, 10, 0, 2}, [](Scene& s) -> double& { return s.brush.push; }));
}

Table make_table() {
    Table table;
    add_domain(table);
    add_time(table);
    add_schemes(table);
    add_forces(table);
    add_pressure(table);
    add_brush(table);
    return table;
}

}  // namespace

std::string Parameter::text(double value) const {
    if (kind == Kind::Switch) return value != 0 ? "true" : "false";
    if (kind == Kind::Choice) return std::string(choices[static_cast<std::size_t>(value)].key);
    return shortest(value);
}

double Parameter::parse(std::string_view text) const {
    if (kind == Kind::Switch) {
        if (text == "true" || text == "on" || text == "1") return 1;
        if (text == "false" || text == "off" || text == "0") return 0;
        throw InputError(key + " = " + std::string(text) + " is neither true nor false");
    }
    if (kind == Kind::Choice) {
        std::vector<std::string_view> keys;
        for (std::size_t k = 0; k < choices.size(); ++k) {
            if (choices[k].key == text) return static_cast<double>(k);
            keys.push_back(choices[k].key);
        }
        throw InputError("unknown " + key + " \"" + std::string(text) + "\"; " + suggestion(text, keys));
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
        throw InputError(key + " = \"" + std::string(text) + "\" is not a number: give one from " +
                         shortest(min) + " to " + shortest(max));
    }
    check(value);
    return value;
}

void Parameter::check(double value) const {
    if (!(value >= min && value <= max)) {
        throw InputError(key + " = " + shortest(value) + " is out of range: " + shortest(min) + " to " +
                         shortest(max));
    }
    if (kind != Kind::Number && value != std::floor(value)) {
        throw InputError(key + " = " + shortest(value) + " is not a whole number");
    }
}

const std::vector<Parameter>& parameters() {
    static const Table table = make_table();
    return table;
}

const Parameter& parameter(std::string_view key) {
    std::vector<std::string_view> keys;
    for (const Parameter& p : parameters()) {
        if (p.key == key) return p;
        keys.push_back(p.key);
    }
    throw InputError("unknown parameter \"" + std::string(key) + "\"; " + suggestion(key, keys));
}

void set_parameter(Scene& scene, std::string_view key, std::string_view text) {
    const Parameter& p = parameter(key);
    p.set(scene, p.parse(text));
}

void set_parameter(Scene& scene, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos) {
        throw InputError("\"" + std::string(assignment) + "\" is not of the form key=value");
    }
    set_parameter(scene, assignment.substr(0, equals), assignment.substr(equals + 1));
}

}  // namespace whorl
