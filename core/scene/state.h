// The fields of a running simulation.
#pragma once

#include "core/grid/boundary.h"
#include "core/scene/scene.h"

namespace whorl {

/// A field of every entry of fields().
struct Fields {
    FaceVelocity velocity;       ///< length/time
    std::vector<Field> scalars;  ///< in the order of scalar()
    Field pressure;              ///< of the last projection, density · length²/time²

    Field& operator[](FieldId id);
    const Field& operator[](FieldId id) const { return const_cast<Fields&>(*this)[id]; }
    Field& density() { return scalars[0]; }
    const Field& density() const { return scalars[0]; }
    Field& temperature() { return scalars[1]; }
    const Field& temperature() const { return scalars[1]; }
};

/// Calls `work(id, field)` for every field, in the table's order.
template <class AnyFields, class Work>
void for_each_field(AnyFields& all, Work&& work) {
    for (std::size_t k = 0; k < fields().size(); ++k) work(FieldId(k), all[FieldId(k)]);
}

struct State : Fields {
    Boundary boundary;
    long step = 0;
    double time = 0;
    /// Of each scalar that is counted: its total at the start plus every change that emitters, brush and
    /// obstacles made since (its unit · length^d).
    std::vector<double> injected;

    const Grid& grid() const { return boundary.grid(); }
    void fill_ghosts() {
        for_each_field(*this, [this](FieldId, Field& field) { boundary.fill(field); });
    }
};

/// The totals of all scalars, in their order; 0 for those that are not counted.
std::vector<double> totals(const State& state);

/// What a field holds in fluid at rest.
Real ambient_value(FieldId id, const Scene& scene);

/// The sides and solid cells that a scene sets.
Boundary boundary_of(const Scene& scene);

/// Still air of the scene's ambient temperature in its domain, with its obstacles.
State make_state(const Scene& scene);

/// ∫q over the fluid (unit of q · length^d).
double total(const Field& centred, const Boundary& boundary);

/// The same fields on another grid of the same domain: values by bilinear interpolation, solid cells by their
/// nearest neighbour. What the change of grid does to totals counts as injected.
State resample(const State& from, const Scene& scene);

/// The point (x, y), in length units, of a field's sample (i, j).
struct WorldPoint {
    double x, y;
};
inline WorldPoint world(const Field& field, const Grid& grid, int i, int j) {
    return {(i + offset_x(field.site())) * grid.h, (j + offset_y(field.site())) * grid.h};
}

/// Sets every sample of a field to `value(point)`, the point in length units.
template <class Value>
void write_samples(Field& field, const Grid& grid, const Value& value) {
    for (int j = 0; j < field.height(); ++j) {
        for (int i = 0; i < field.width(); ++i)
            field(i, j) = static_cast<Real>(value(world(field, grid, i, j)));
    }
}

/// The bilinear value of a field at a point in length units; outside the domain the nearest one.
Real value_at(const Field& field, const Boundary& boundary, WorldPoint at);

}  // namespace whorl
