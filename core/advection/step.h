// One step A of a base scheme for fields: what every advector is made of.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/advection/kernels.h"
#include "core/advection/lattice.h"
#include "core/advection/transport.h"

namespace whorl {

/// Fields at one site that one trace serves: as many as a pass takes.
struct Group {
    static constexpr int max_fields = 2;
    std::array<const Field*, max_fields> from{};
    std::array<Field*, max_fields> to{};
    int count = 0;

    /// @pre count < max_fields
    void add(const Field& q, Field& out) {
        from[count] = &q;
        to[count++] = &out;
    }
    const Field& shape() const { return *from[0]; }
    std::span<const Field* const> sources() const { return std::span(from).first(count); }
};

/// Groups at different sites that are advected by the same schemes.
using Groups = std::span<const Group>;
/// One a site.
inline constexpr std::size_t max_groups = 3;

/// Any number of fields, dealt out to passes of at most one group a site.
class Pass {
  public:
    /// The fields of pass `number`, in order; none after the last pass.
    Pass(std::span<const AdvectedField> fields, int number);
    Groups groups() const { return std::span(groups_).first(count_); }
    bool empty() const { return count_ == 0; }

  private:
    std::array<Group, max_groups> groups_;
    std::size_t count_ = 0;
};

/// New values of a span, a row a field of the group.
struct GroupValues {
    alignas(64) Values of[Group::max_fields];
    Values& operator[](int f) { return of[f]; }
};

/// The result of a base step for a span of one group's nodes.
struct StepResult {
    int group;
    NodeSpan nodes;
    const CellPositions& at;   ///< departure points of the nodes
    GroupValues& q;            ///< new values, unclamped
    GroupValues& first_order;  ///< with particles: the linear semi-Lagrangian values
};

/// What to do with each result; refers to a callable that outlives it.
class Store {
  public:
    template <class F>
    Store(F& finish)  // NOLINT(google-explicit-constructor): a callable is one
        : callable_(&finish),
          call_([](void* f, const StepResult& result) { (*static_cast<F*>(f))(result); }) {}
    void operator()(const StepResult& result) const { call_(callable_, result); }

  private:
    void* callable_;
    void (*call_)(void*, const StepResult&);
};

/// The base step with everything decided: which loops, which particles, which flow.
struct Step {
    Kernels kernels;
    std::span<const Particle> particles;
    const Lattice* lattice;        ///< which the particles of all nodes form; null where they do not
    std::span<LatticeTile> tiles;  ///< one a thread, with a lattice
    const FaceVelocity* velocity;
    const Boundary* boundary;
    Pool* pool;
    Real dt;  ///< step over cell size, time/length

    /// One base step of every group, handed to `finish` span by span, on all threads.
    /// [T alg 3.1 without particles, 4.1 with them; unclamped]
    /// @param direction −1 traces forward
    template <class F>
    void apply(Groups groups, Real direction, F finish) const {
        pool->bands(most_rows(groups), [&, this](int first, int last, int thread) {
            if (lattice == nullptr) {
                plain_band(groups, direction, first, last, finish);
            } else {
                lattice_band(*this, groups, direction, first, last, tiles[thread], finish);
            }
        });
    }

    /// Where the flow brings the nodes of a span from.
    void departure(NodeSpan nodes, const Field& shape, Real direction, CellPositions& out) const;

  private:
    static int most_rows(Groups groups);
    /// Rows [first, last), node by node: each traces its own particles.
    void plain_band(Groups groups, Real direction, int first, int last, Store finish) const;
    void plain_span(const Group& group, NodeSpan nodes, Real direction, const StepResult& out) const;
};

/// The intermediate fields of the predictor-correctors for one group, kept from step to step.
struct Workspace {
    std::array<Field, Group::max_fields> forward;
    std::array<Field, Group::max_fields> corrected;
    /// The cell of each node's forward departure point, as CellPositions::at; a row may be read a span too
    /// far.
    std::vector<Index> cells;

    Index* departures(NodeSpan nodes, const Field& shape) {
        return cells.data() + static_cast<std::size_t>(nodes.j) * shape.width() + nodes.i;
    }
    /// Brings the fields into a group's shape; allocates only when that has changed.
    void shape_like(const Group& group);
};

}  // namespace whorl
