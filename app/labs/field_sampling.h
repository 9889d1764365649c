// A field between its samples, as the solver reads it.
#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "core/advection/scheme_set.h"

namespace whorl::app {

/// Interpolates a field with the loops that advection uses, not with a copy of them.
/// @param field    ghosts filled
/// @param schemes  its interpolation, clamping and axis order are used
/// @param places   in samples from sample (0, 0)
/// @param out      as many values, unit of the field
void sample_field(const Field& field, const SchemeSet& schemes, Wraps wraps,
                  std::span<const glm::dvec2> places, std::span<float> out);

/// The place of a row's sample, moved off a point to its left: where a curve jumps, the point itself belongs
/// to the interval that begins there.
inline double from_the_left(double x) {
    return x - 1e-6;
}

}  // namespace whorl::app
