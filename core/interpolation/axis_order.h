// The axis along which a separable interpolation goes first.
#pragma once

#include "core/base/id.h"
#include "core/base/scheme_info.h"

namespace whorl {

struct AxisOrder {
    SchemeInfo info;
    bool x_first;

    static Registry<AxisOrder>& list();
};

}  // namespace whorl
