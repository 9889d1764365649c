// A scene: the whole setup of a run as a plain value.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/advection/scheme_set.h"
#include "core/grid/boundary.h"
#include "core/scene/field_list.h"

namespace whorl {

/// A rectangle that holds scalars at their amounts in a window of time.
struct Emitter {
    double x = 20, y = 1;                                    ///< centre, length
    double width = 4, height = 2;                            ///< length
    Amounts amounts = emitter_amounts();                     ///< held inside
    double from = 0;                                         ///< time at which it opens
    double until = std::numeric_limits<double>::infinity();  ///< time at which it shuts
    bool operator==(const Emitter&) const = default;
};

/// A solid disc, or a solid rectangle where its radius is 0.
struct Obstacle {
    double x = 20, y = 20;         ///< centre, length
    double radius = 0;             ///< length
    double width = 0, height = 0;  ///< length
    bool operator==(const Obstacle&) const = default;
};

/// What a drag of the mouse does to the fluid.
struct Brush {
    double radius = 2;                  ///< length
    Amounts amounts = brush_amounts();  ///< that a stroke brings the fluid to
    double push = 1;                    ///< share of the mouse's velocity that the fluid takes
    bool operator==(const Brush&) const = default;
};

struct Scene {
    std::string title;
    std::string experiment = "empty";  ///< key of what the run starts from, see experiments()

    double width = 40, height = 40;  ///< length
    int resolution = 40;             ///< cells along the width
    int dimensions = 2;              ///< 1 takes a single row of cells
    Sides sides;

    double dt = 1.0 / 60;   ///< time
    int steps = 600;        ///< of a run without a window
    std::size_t order = 0;  ///< index into step_orders()

    SchemeSet velocity;  ///< how the velocity is advected
    SchemeSet scalars;   ///< how density and temperature are
    bool linked = true;  ///< one choice sets both

    double alpha = 0;        ///< weight of smoke, acceleration per density  [F 4]
    double beta = 0;         ///< lift of heat, acceleration per degree  [F 4]
    double ambient = 5;      ///< T_amb
    double confinement = 0;  ///< ε of vorticity confinement  [F 13]

    std::size_t pressure = 0;  ///< index into pressure_solvers()
    double tolerance = 1e-5;   ///< of iterative pressure solvers

    std::uint64_t seed = 1;  ///< of the jittered stencil
    Brush brush;
    std::vector<Emitter> emitters;
    std::vector<Obstacle> obstacles;

    /// The grid of this scene: `resolution` cells along the width, as many rows of them as fit the height.
    Grid grid() const;
    bool operator==(const Scene&) const = default;
};

/// Why the choices of a scene do not go together, one line, or nothing if they do.
std::string conflict(const Scene& scene);

}  // namespace whorl
