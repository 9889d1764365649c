// The fields of a running simulation.
#pragma once

#include "core/grid/boundary.h"
#include "core/scene/scene.h"

namespace whorl {

struct State {
    Boundary boundary;
    FaceVelocity velocity;  ///< length/time
    Field density;          ///< ρ
    Field temperature;      ///< T
    Field pressure;         ///< of the last projection, density · length²/time²
    long step = 0;
    double time = 0;
    /// ∫ρ at the start plus every change that emitters, brush and obstacles made since (density · length^d).
    double put_in = 0;

    const Grid& grid() const { return boundary.grid(); }
    void fill_ghosts() {
        boundary.fill(velocity);
        for (Field* field : {&density, &temperature, &pressure}) boundary.fill(*field);
    }
};

/// The sides and solid cells that a scene sets.
Boundary boundary_of(const Scene& scene);

/// Still air of the scene's ambient temperature in its domain, with its obstacles.
State make_state(const Scene& scene);

/// ∫q over the fluid (unit of q · length^d).
double total(const Field& centred, const Boundary& boundary);

/// The same fields on another grid of the same domain: values by bilinear interpolation, solid cells by their
/// nearest neighbour. What the change of grid does to ∫ρ counts as put in.
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
