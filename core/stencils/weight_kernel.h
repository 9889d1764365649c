// How much each particle of an ASLAM node counts, by its distance: an entry of a list.  [T 4.4–4.9]
#pragma once

#include "core/base/id.h"
#include "core/base/scheme_info.h"

namespace whorl {

struct WeightKernel {
    SchemeInfo info;
    /// Before weights are normalised.
    /// @param r      from the node, cells
    /// @param radius Δ_r = ½√d cells, the circumscribed circle's of a cell
    double (*weight)(double r, double radius);

    /// All kernels; the first is the default.
    static Registry<WeightKernel>& list();
};

}  // namespace whorl
