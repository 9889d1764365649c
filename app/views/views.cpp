#include "app/views/views.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/suggest.h"
#include "core/derived/derived.h"
#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

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
    if (!is_solved(s)) return nullptr;
    return s.limits ? &s.limits->velocity : zeros(s, scratch);
}

using Middle = FieldDisplay::Middle;

View view_of(FieldId id) {
    const FieldInfo& info = id.info();
    return {*info.display, info.key, [id](const Snapshot& s, Field&) { return &s.state[id]; }};
}

View view_of(const DerivedField& derived) {
    return {derived.display, derived.key, [&derived](const Snapshot& s, Field& scratch) {
                static Pool alone(1);  // a window's thread does not wait for others
                if (!scratch.same_shape(s.density())) scratch = s.density();
                derived.compute(s.state, alone, scratch);
                return &scratch;
            }};
}

/// What only a snapshot knows.
std::vector<View> views_of_snapshots() {
    return {
        {{"Exact solution", "ρ", "What the density would be without any error.", "magma", Middle::None, 70},
         "exact",
         [](const Snapshot& s, Field&) { return s.has_exact ? &s.exact : nullptr; }},
        {{"Difference", "ρ", "Numerical less exact density.", "blue-dark-red", Middle::Zero, 80},
         "difference",
         difference},
        {{"Limited smoke", "", "Cells whose smoke a limiter changed in the last step.", "magma", Middle::None,
          90},
         "limited-smoke",
         limited_smoke,
         true},
        {{"Limited velocity", "share of faces",
          "How many of a cell's faces had their velocity changed by a limiter in the last step.", "magma",
          Middle::None, 100},
         "limited-velocity",
         limited_velocity,
         true},
    };
}

/// All views; those that tables make are kept here.
struct ViewList {
    std::deque<View> made;
    Registry<View> all{"view", {}};

    ViewList() {
        for (std::size_t k = 0; k < fields().size(); ++k) {
            if (fields()[k].display) made.push_back(view_of(FieldId(k)));
        }
        for (const DerivedField* derived : derived_fields().all()) made.push_back(view_of(*derived));
        for (View& view : views_of_snapshots()) made.push_back(std::move(view));
        std::stable_sort(made.begin(), made.end(),
                         [](const View& a, const View& b) { return a.rank < b.rank; });
        for (const View& view : made) all.add(view);
    }
};

Registry<View>& list() {
    static ViewList views;
    return views.all;
}

}  // namespace

bool is_solved(const Snapshot& lane) {
    return experiment(lane.scene.experiment).flow == nullptr;
}

std::span<const View* const> views() {
    return list().all();
}

void add_view(const View& view) {
    list().add(view);
}

const View& view(std::string_view key) {
    return list().find(key);
}

float View::centre(const Snapshot& snapshot) const {
    return middle == Middle::Ambient ? static_cast<float>(snapshot.scene.ambient) : 0;
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
    if (!diverges()) return {0, extent.hi};
    const float from = centre(snapshot);
    const float far = std::max(from - extent.lo, extent.hi - from);
    return {from - far, from + far};
}

Range View::automatic_range(const Snapshot& snapshot, const Field& values) const {
    const Range range = shown(snapshot, extent(snapshot, values));
    const float from = centre(snapshot);
    return range.lo < range.hi ? range : Range{diverges() ? from - 1 : 0, from + 1};
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
