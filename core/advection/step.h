// One step A of a base scheme for a run of nodes: what every advector is made of.
#pragma once

#include <array>
#include <span>

#include "core/advection/kernels.h"
#include "core/grid/boundary.h"
#include "core/parallel/pool.h"

namespace whorl {

/// Fields at one site that move together, so that one trace serves them all.
struct Group {
    static constexpr int max_fields = 2;
    std::array<const Field*, max_fields> from{};
    std::array<Field*, max_fields> to{};
    int count = 0;

    void add(const Field& q, Field& out) {
        from[count] = &q;
        to[count++] = &out;
    }
    const Field& shape() const { return *from[0]; }
};

/// New values of a run, a row a field of the group.
using GroupValues = std::array<Values, Group::max_fields>;

/// The base step with everything decided: which loops, which particles, which flow.
struct Step {
    Kernels kernels;
    std::span<const Particle> particles;
    Flow flow;
    const Boundary* boundary;
    Pool* pool;
    Real dt;  ///< step over cell size, time/length

    /// Where the flow brings the nodes of a run from; `direction` −1 traces forward.
    void departure(Run run, const Field& shape, Real direction, Places& out) const;

    /// One base step for a run.  [T alg 3.1 without particles, 4.1 with them; unclamped]
    /// @param at          departure points of the nodes
    /// @param first_order the linear semi-Lagrangian values there, which limiters may revert to
    void base(Run run, const Group& group, const Places& at, Real direction, GroupValues& out,
              GroupValues& first_order) const;

    /// Calls `work(run)` for runs that cover a field's nodes, on all threads.
    template <class Work>
    void for_runs(const Field& shape, Work&& work) const {
        pool->bands(shape.height(), [&](int first, int last) {
            for (int j = first; j < last; ++j) {
                for (int i = 0; i < shape.width(); i += Run::size) {
                    work(Run{i, j, std::min(Run::size, shape.width() - i)});
                }
            }
        });
    }
};

/// The intermediate fields of the predictor-correctors, kept from step to step.
struct Workspace {
    std::array<Field, Group::max_fields> forward;
    std::array<Field, Group::max_fields> corrected;

    /// Brings the fields into a group's shape; allocates only when that has changed.
    void shape_like(const Group& group);
};

}  // namespace whorl
