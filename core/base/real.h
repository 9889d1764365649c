// The number type of a field's values, and vectors of it.
#pragma once

#include <glm/vec2.hpp>

#ifndef WHORL_REAL
#define WHORL_REAL float
#endif

namespace whorl {

using Real = WHORL_REAL;
using Vec2 = glm::vec<2, Real>;

}  // namespace whorl
