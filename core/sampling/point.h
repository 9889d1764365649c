// A point or a vector of the plane, or a vector of them.
#pragma once

#include "core/parallel/simd.h"

namespace whorl {

/// Both components in cells, or cells/time.
template <class T>
struct Point {
    T x, y;

    friend WHORL_INLINE Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend WHORL_INLINE Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend WHORL_INLINE Point operator*(Real s, Point a) { return {s * a.x, s * a.y}; }
};

}  // namespace whorl
