#include "app/views/views.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/suggest.h"
#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

float about_zero(const Snapshot&) {
    return 0;
}

const Field* difference(const Snapshot& s, Field& scratch) {
    if (!s.has_exact) return nullptr;
    if (!scratch.same_shape(s.density())) scratch = s.density();
    for (int j = 0; j < scratch.height(); ++j) {
        for (int i = 0; i < scratch.width(); ++i) scratch(i, j) = s.density()(i, j) - s.exact(i, j);
    }
    return &scratch;
}

const Field* zeros(const Snapshot& s, Field& scratch) {
    if (!scratch.same_shape(s.density())) scratch = s.density();
    scratch.set_all(0);
    return &scratch;
}

const Field* limited_smoke(const Snapshot& s, Field& scratch) {
    return s.limits ? &s.limits->density : zeros(s, scratch);
}

const Field* limited_velocity(const Snapshot& s, Field& scratch) {
    if (experiment(s.scene.experiment).flow != nullptr) return nullptr;
    return s.limits ? &s.limits->velocity : zeros(s, scratch);
}

constexpr View table[] = {
    {"density", "Smoke density", "ρ", "How much smoke there is.", "magma",
     [](const Snapshot& s, Field&) { return &s.density(); }, nullptr},
    {"temperature", "Temperature", "degrees", "Cold is blue, warm is red, still air is in the middle.",
     "blue-red", [](const Snapshot& s, Field&) { return &s.state.temperature(); },
     [](const Snapshot& s) { return static_cast<float>(s.scene.ambient); }},
    {"speed", "Speed", "length/time", "|u| at cell centres.", "viridis",
     [](const Snapshot& s, Field&) { return &s.speed; }, nullptr},
    {"vorticity", "Vorticity", "1/time", "ω = ∂v/∂x − ∂u/∂y: red turns to the left, blue to the right.",
     "blue-dark-red", [](const Snapshot& s, Field&) { return &s.vorticity; }, about_zero},
    {"pressure", "Pressure", "p", "Of the last projection.", "blue-dark-red",
     [](const Snapshot& s, Field&) { return &s.state.pressure; }, about_zero},
    {"divergence", "Divergence", "1/time", "∇·u at the step's end: what the next projection takes away.",
     "blue-dark-red", [](const Snapshot& s, Field&) { return &s.divergence; }, about_zero},
    {"exact", "Exact solution", "ρ", "What the density would be without any error.", "magma",
     [](const Snapshot& s, Field&) { return s.has_exact ? &s.exact : nullptr; }, nullptr},
    {"difference", "Difference", "ρ", "Numerical less exact density.", "blue-dark-red", difference,
     about_zero},
    {"limited-smoke", "Limited smoke", "", "Cells whose smoke a limiter changed in the last step.", "magma",
     limited_smoke, nullptr, true},
    {"limited-velocity", "Limited velocity", "share of faces",
     "How many of a cell's faces had their velocity changed by a limiter in the last step.", "magma",
     limited_velocity, nullptr, true},
};

}  // namespace

std::span<const View> views() {
    return table;
}

const View& view(std::string_view key) {
    std::vector<std::string_view> keys;
    for (const View& v : views()) {
        if (v.key == key) return v;
        keys.push_back(v.key);
    }
    throw InputError("unknown view \"" + std::string(key) + "\"; " + suggestion(key, keys));
}

Range View::extent(const Snapshot& snapshot, const Field& values) const {
    const float from = centre(snapshot);
    Range span{from, from};
    for (int j = 0; j < values.height(); ++j) {
        for (int i = 0; i < values.width(); ++i) {
            if (snapshot.solids()[static_cast<std::size_t>(j) * values.width() + i] != 0) continue;
            const float value = static_cast<float>(values(i, j));
            span = {std::min(span.lo, value), std::max(span.hi, value)};
        }
    }
    return span;
}

Range View::shown(const Snapshot& snapshot, Range extent) const {
    if (!middle) return {0, extent.hi};
    const float from = centre(snapshot);
    const float far = std::max(from - extent.lo, extent.hi - from);
    return {from - far, from + far};
}

Range View::automatic_range(const Snapshot& snapshot, const Field& values) const {
    const Range range = shown(snapshot, extent(snapshot, values));
    const float from = centre(snapshot);
    return range.lo < range.hi ? range : Range{middle ? from - 1 : 0, from + 1};
}

void take_shown(Session& session, const View& view, const SessionSnapshot& last, Pool& pool,
                SessionSnapshot& out) {
    const bool watched = session.watches_limiters();
    session.watch_limiters(watched || view.of_limiters);
    take_snapshot(session, last, pool, out);
    session.watch_limiters(watched);
}

std::string describe(const SchemeSet& s) {
    std::string text(s.advector.info().label);
    if (s.predictor_corrector() && s.affine()) text += " over " + std::string(s.base.info().label);
    if (s.affine()) {
        text += " · ζ = " + std::to_string(s.zeta);
        if (s.zeta > 0)
            text += " · " + std::string(s.weights.info().label) + " · " + std::string(s.stencil.info().label);
    } else {
        text += " · " + std::string(s.interpolation.info().label) + (s.clamped ? ", clamped" : "");
    }
    if (s.advector->traits.limited && s.limiter != Id<Limiter>()) {
        text += " · limiter: " + std::string(s.limiter.key());
    }
    return text + " · " + std::string(s.tracer.info().label);
}

std::string describe(const Scene& scene) {
    if (scene.velocity == scene.scalars) return describe(scene.scalars);
    return "Velocity: " + describe(scene.velocity) + "\nScalars: " + describe(scene.scalars);
}

std::string caption(const Snapshot& s) {
    return describe(s.scene) + "\n" + std::to_string(s.grid().nx) + " × " + std::to_string(s.grid().ny) +
           " · Δt = " + figure(s.scene.dt) + " · step " + std::to_string(s.measures.step) +
           " · t = " + figure(s.measures.time);
}

std::string bar_label(const View& view) {
    return std::string(view.label) + "  " + std::string(view.unit);
}

}  // namespace whorl::app
