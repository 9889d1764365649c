// The axis along which a separable interpolation goes first.
#pragma once

#include "core/schemes/scheme.h"

namespace whorl {

struct XFirst {
    static constexpr SchemeInfo info{"x-first", "x, then y", "thesis sec. 3.1",
                                     "The thesis' order. The limited cubics depend on it."};
    static constexpr bool x_first = true;
};
struct YFirst {
    static constexpr SchemeInfo info{"y-first", "y, then x", "thesis sec. 3.1",
                                     "The other order, to compare."};
    static constexpr bool x_first = false;
};

}  // namespace whorl
