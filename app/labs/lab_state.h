// What a person has chosen in the labs.
#pragma once

#include <optional>
#include <vector>

#include "app/inspector/inspector.h"
#include "app/labs/slice.h"
#include "app/plot/plot.h"
#include "core/interpolation/interpolation.h"
#include "core/stencils/stencil.h"

namespace whorl::app {

/// On or off for every interpolation of the list.
using ShownInterpolations = std::vector<bool>;

inline ShownInterpolations all_interpolations() {
    return ShownInterpolations(Interpolation::list().all().size(), true);
}

struct InterpolationLab {
    bool open = false;
    std::size_t data_set = 0;   ///< index into data_sets()
    std::vector<float> values;  ///< the data set's, as they have been dragged
    int interval = 0;           ///< the chosen one begins at this point
    ShownInterpolations shown = all_interpolations();
    bool clamped = false;
    std::optional<std::size_t> dragged;  ///< the point that the pointer holds
    std::optional<std::size_t> pointed;  ///< the interpolation whose row is under the pointer
    Interval y{0, 1};                    ///< of the plot, held while a point is dragged
};

struct StencilLab {
    bool open = false;
    struct Choice {
        Id<StencilShape> kind;
        Id<WeightKernel> weights;
        int zeta = 2;
        int dimensions = 2;
        int seed = 1;
        bool operator==(const Choice&) const = default;
    } choice;
    Choice made;  ///< what `stencil` was made for
    std::optional<Stencil> stencil;
};

struct SliceLab {
    bool open = false;
    SliceLine line;
    bool compares_interpolations = false;  ///< of the selected lane, instead of the lanes
    ShownInterpolations shown = all_interpolations();
    bool clamped = false;
    FilledFields fields;
    FilledFields exact;                         ///< solutions, by the lane that knows them
    SliceGrip held = SliceGrip::None;           ///< what the pointer drags
    SliceGrip under_pointer = SliceGrip::None;  ///< what it would drag
    std::optional<double> pointed_on_field;     ///< the part of the line under the pointer, 0 to 1 ...
    std::optional<double> pointed_in_plot;      ///< ... and under the plot's hairline

    SliceGrip grip() const { return held != SliceGrip::None ? held : under_pointer; }
};

struct LabState {
    InterpolationLab interpolation;
    StencilLab stencil;
    SliceLab slice;
    Inspector inspector;
    /// The column that a lab may stand over: its left edge and width, pixels.
    struct Side {
        float x = 0, width = 0;
        bool beside_lessons = false;  ///< it is another one then
    } side;
    bool stood_beside_lessons = false;  ///< where such a lab was put last
    bool under_pointer = false;         ///< a lab's window is: the field below takes no strokes
};

}  // namespace whorl::app
