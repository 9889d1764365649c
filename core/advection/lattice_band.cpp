// The base step of the affine family over a shared lattice.
#include <algorithm>

#include "core/advection/step.h"

namespace whorl {
namespace {

/// b > 0
int floor_div(int a, int b) {
    return (a >= 0 ? a : a - b + 1) / b;
}

/// One band of rows in one tile's width: cells first_cell … end_cell − 1.
class Band {
  public:
    Band(const Step& step, Groups groups, Real direction, LatticeTile& tile, int first_cell, int end_cell)
        : step_(step),
          lattice_(*step.lattice),
          groups_(groups),
          dt_(direction * step.dt),
          direction_(direction),
          tile_(tile),
          first_cell_(first_cell),
          end_cell_(end_cell) {
        for (const Group& group : groups_) {
            lowest_ = std::min(lowest_, lattice_.lowest(site(group)));
            highest_ = std::max(highest_, lattice_.highest(site(group)));
        }
        find_reaches();
        find_sources();
    }

    void run(int first, int last, Store finish) {
        const int m = lattice_.per_cell();
        int next = m * first + lowest_;  // the lattice row to trace
        for (int j = first; j < last; ++j) {
            for (int g = 0; g < static_cast<int>(groups_.size()); ++g) {
                if (j >= groups_[g].shape().height()) continue;
                for (; next <= m * j + lattice_.highest(site(groups_[g])); ++next) trace_row(next);
            }
            for (int y = lowest_; y <= highest_; ++y) rows_[y - lowest_] = tile_.row(m * j + y, 0);
            for (int g = 0; g < static_cast<int>(groups_.size()); ++g) {
                if (j < groups_[g].shape().height()) update_row(g, j, finish);
            }
        }
    }

  private:
    /// For which groups points of one kind are wanted, and the cells around a node where they lie.
    struct Reach {
        unsigned groups = 0;
        int low = 0, high = 0;
    };

    static Site site(const Group& group) { return group.shape().site(); }

    void find_reaches() {
        const int m = lattice_.per_cell();
        const auto add = [&](int g, const Lattice::Point& p) {
            const int cell = floor_div(p.x, m);
            Reach& reach = reaches_[p.y - m * floor_div(p.y, m)][p.x - m * cell];
            reach.low = reach.groups == 0 ? cell : std::min(reach.low, cell);
            reach.high = reach.groups == 0 ? cell : std::max(reach.high, cell);
            reach.groups |= 1U << g;
        };
        for (int g = 0; g < static_cast<int>(groups_.size()); ++g) {
            for (const Lattice::Point& p : lattice_.particles(site(groups_[g]))) add(g, p);
            if (const auto& node = lattice_.node(site(groups_[g]))) add(g, *node);
        }
    }

    void find_sources() {
        const int m = lattice_.per_cell();
        int row = LatticeTile::displacement_rows;
        for (int g = 0; g < static_cast<int>(groups_.size()); ++g) {
            const auto particles = lattice_.particles(site(groups_[g]));
            for (std::size_t k = 0; k < particles.size(); ++k) {
                const Lattice::Point& p = particles[k];
                const int cell = floor_div(p.x, m);
                const int x = p.x - m * cell;
                tile_.sources(g)[k] = {p.y - lowest_,
                                       tile_.point(x) + row * LatticeTile::stride + cell - reach(p.y, x).low,
                                       &p.particle};
            }
            row += groups_[g].count * ParticleSamples::rows;
        }
    }

    const Reach& reach(int y, int x) const {
        const int m = lattice_.per_cell();
        return reaches_[y - m * floor_div(y, m)][x];
    }

    /// What the points of kind (x, y) carry in cell i's column. Rows start with the first cell in reach, so
    /// that whole vectors are written to whole cache lines.
    Real* at(int y, int x, int i) { return tile_.row(y, x) + (i - first_cell_ - reach(y, x).low); }

    /// Traces a row of points, and samples all fields there.
    void trace_row(int y) {
        const int m = lattice_.per_cell();
        const int j = floor_div(y, m);
        for (int x = 0; x < m; ++x) {
            const Reach& wanted = reach(y, x);
            if (wanted.groups == 0) continue;
            const int i = first_cell_ + wanted.low;
            trace_points({i, j, end_cell_ + wanted.high - i}, y, x, wanted.groups);
        }
    }

    void trace_points(NodeSpan nodes, int y, int x, unsigned wanted) {
        constexpr auto stride = LatticeTile::stride;
        Real* to = at(y, x, nodes.i);
        step_.kernels.trace({step_.velocity, Site::Centre}, nodes,
                            lattice_.start(x, y - lattice_.per_cell() * nodes.j), dt_, to, to + stride);
        Real* samples = to + LatticeTile::displacement_rows * stride;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const Group& group = groups_[g];
            if ((wanted >> g & 1U) != 0) {
                step_.kernels.sample_particles(group.sources(), Site::Centre, nodes, to, to + stride,
                                               {samples, stride});
            }
            samples += group.count * ParticleSamples::rows * stride;
        }
    }

    void update_row(int g, int j, Store finish) {
        const int end = std::min(end_cell_, groups_[g].shape().width());
        for (int i = first_cell_; i < end; i += NodeSpan::size) {
            update_span(g, {i, j, std::min(NodeSpan::size, end - i)}, finish);
        }
    }

    void update_span(int g, NodeSpan nodes, Store finish) {
        constexpr auto stride = LatticeTile::stride;
        const Group& group = groups_[g];
        const int m = lattice_.per_cell();
        int row = LatticeTile::displacement_rows;
        for (int k = 0; k < g; ++k) row += groups_[k].count * ParticleSamples::rows;
        CellPositions positions;
        GroupValues q, first_order;
        Real* node = nullptr;
        if (const auto& own = lattice_.node(site(group))) {
            node = at(m * nodes.j + own->y, own->x, nodes.i);
            step_.kernels.locate(group.shape(), Site::Centre, nodes, node, node + stride, positions);
        } else {
            step_.departure(nodes, group.shape(), direction_, positions);
        }
        const std::size_t count = lattice_.particles(site(group)).size();
        const std::span<Contribution> contributions = tile_.contributions().first(count);
        const std::span<const LatticeTile::Source> sources = tile_.sources(g);
        for (std::size_t k = 0; k < count; ++k) {
            const LatticeTile::Source& source = sources[k];
            contributions[k] = {rows_[source.row] + source.offset + (nodes.i - first_cell_), source.particle};
        }
        for (int f = 0; f < group.count; ++f) {
            if (node) {
                std::copy_n(node + (row + f * ParticleSamples::rows) * stride, nodes.count, first_order[f]);
            } else {
                step_.kernels.sample_linear(*group.from[f], positions, nodes.count, first_order[f]);
            }
            Values sum{};
            step_.kernels.add_contributions(contributions, stride, nodes.count, first_order[f], sum);
            for (int k = 0; k < nodes.count; ++k) q[f][k] = first_order[f][k] + sum[k];
            for (Contribution& one : contributions) one.values += ParticleSamples::rows * stride;
        }
        finish({g, nodes, positions, q, first_order});
    }

    const Step& step_;
    const Lattice& lattice_;
    Groups groups_;
    Real dt_;
    Real direction_;
    LatticeTile& tile_;
    int first_cell_, end_cell_;
    int lowest_ = 0, highest_ = 0;
    Reach reaches_[Lattice::max_per_cell][Lattice::max_per_cell];
    std::array<Real*, Lattice::max_rows> rows_{};  ///< of lattice points around a row of nodes
};

}  // namespace

void lattice_band(const Step& step, Groups groups, Real direction, int first, int last, LatticeTile& tile,
                  Store finish) {
    int width = 0;
    for (const Group& group : groups) width = std::max(width, group.shape().width());
    for (int i = 0; i < width; i += LatticeTile::max_cells) {
        const int end = std::min(i + LatticeTile::max_cells, width);
        Band(step, groups, direction, tile, i, end).run(first, last, finish);
    }
}

}  // namespace whorl
