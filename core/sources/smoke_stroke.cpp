#include "core/sources/smoke_stroke.h"

#include <algorithm>

#include "core/scene/parameters.h"

namespace whorl {
namespace {

constexpr std::string_view numbers[] = {"x0",      "y0",          "x1",   "y1", "radius",
                                        "density", "temperature", "push", "u",  "v"};

SmokeStroke stroke_of(const Edit& edit, bool smoke) {
    const std::vector<double>& n = edit.numbers;
    SmokeStroke stroke{.along = {n[0], n[1], n[2], n[3]},
                       .radius = n[4],
                       .amounts = edit.amounts,
                       .push = n[7],
                       .velocity_x = n[8],
                       .velocity_y = n[9],
                       .smoke = smoke};
    stroke.amounts.set(field::density, n[5]);
    stroke.amounts.set(field::temperature, n[6]);
    return stroke;
}

void check(const Edit& edit) {
    parameter("brush.radius").check(edit.numbers[4]);
}

/// 1 on the line, 0 at the radius, smooth at both ends.
double falloff(double distance, double radius) {
    const double s = std::min(distance / radius, 1.0);
    return (1 - s * s) * (1 - s * s);
}

void drag(Field& field, const State& state, const SmokeStroke& stroke, double velocity) {
    for_samples_near(stroke.along, stroke.radius, field, state.grid(), [&](int i, int j, double distance) {
        const double take = std::min(1.0, stroke.push * falloff(distance, stroke.radius));
        field(i, j) += static_cast<Real>(take * (stroke.push * velocity - static_cast<double>(field(i, j))));
    });
}

void bring(FieldId id, State& state, const SmokeStroke& stroke) {
    Field& field = state[id];
    const double amount = stroke.amounts[id];
    const bool raises = id.info().source->stroke == Source::Stroke::Raise;
    double change = 0;
    for_samples_near(stroke.along, stroke.radius, field, state.grid(), [&](int i, int j, double distance) {
        if (state.boundary.solid(i, j)) return;
        const double share = falloff(distance, stroke.radius);
        const Real value = field(i, j);
        const double before = static_cast<double>(value);
        if (raises) {
            const double after = std::max(before, amount * share);
            change += after - before;
            field(i, j) = static_cast<Real>(after);
        } else {
            const Real step = static_cast<Real>(share * (amount - before));
            change += static_cast<double>(step);
            field(i, j) = value + step;
        }
    });
    if (id.info().counted) state.injected[scalar_index(id)] += change * state.grid().cell();
}

CellRange act(const SmokeStroke& stroke, State& state) {
    if (stroke.smoke) {
        for_sources([&](FieldId id) { bring(id, state, stroke); });
    }
    if (stroke.push > 0 && (stroke.velocity_x != 0 || stroke.velocity_y != 0)) {
        drag(state.velocity.u, state, stroke, stroke.velocity_x);
        drag(state.velocity.v, state, stroke, stroke.velocity_y);
        state.boundary.enforce(state.velocity);
    }
    state.fill_ghosts();
    return cells_near(stroke.along, stroke.radius, state.grid());
}

}  // namespace

extern constinit const EditVerb smoke_verb{
    .info{"smoke", "Smoke", "", "Brings smoke and heat along a segment, and drags the fluid along."},
    .numbers = numbers,
    .takes_amounts = true,
    .check = check,
    .apply = [](const Edit& e, State& state, const Scene&) { return act(stroke_of(e, true), state); }};

extern constinit const EditVerb push_verb{
    .info{"push", "Push", "", "The same numbers, without smoke and heat."},
    .numbers = numbers,
    .takes_amounts = true,
    .check = check,
    .apply = [](const Edit& e, State& state, const Scene&) { return act(stroke_of(e, false), state); }};

SmokeStroke::operator Edit() const {
    Edit edit{smoke ? smoke_verb : push_verb,
              {along.x0, along.y0, along.x1, along.y1, radius, amounts[field::density],
               amounts[field::temperature], push, velocity_x, velocity_y},
              amounts};
    edit.amounts.set(field::density, 0);
    edit.amounts.set(field::temperature, 0);
    return edit;
}

}  // namespace whorl
