// The list of axis orders.
#include "core/interpolation/axis_order.h"

namespace whorl {
namespace {

constexpr AxisOrder along_x{
    .info{"x-first", "x, then y", "thesis sec. 3.1", "The thesis' order. The limited cubics depend on it."},
    .x_first = true};
constexpr AxisOrder along_y{.info{"y-first", "y, then x", "thesis sec. 3.1", "The other order, to compare."},
                            .x_first = false};

}  // namespace

Registry<AxisOrder>& AxisOrder::list() {
    static Registry<AxisOrder> list("axis order", {&along_x, &along_y});
    return list;
}

}  // namespace whorl
