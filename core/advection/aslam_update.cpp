#include "core/advection/aslam_update.h"

#include <algorithm>

namespace whorl {

void advect_aslam(const Step& step, Groups groups, std::span<Workspace>) {
    step.apply(groups, 1, [&](const StepResult& r) {
        const Group& group = groups[r.group];
        for (int f = 0; f < group.count; ++f) {
            step.kernels.limit(*group.from[f], r.at.at, r.nodes.count, r.first_order[f], r.q[f]);
            std::copy_n(r.q[f], r.nodes.count, group.to[f]->row(r.nodes.j) + r.nodes.i);
        }
    });
}

}  // namespace whorl
