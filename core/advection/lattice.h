// The lattice that the particles of neighbouring nodes share.  [T table 4.1]
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/advection/kernels.h"

namespace whorl {

struct Group;
class Store;
struct Step;

/// Particles of neighbouring nodes start from the same points: one lattice with `per_cell` points a cell
/// along each axis, the first of them `phase` steps from the cell's low side. Face and centre nodes share it,
/// so every departure point is traced once for all fields.
class Lattice {
  public:
    /// Along an axis, at most.
    static constexpr int max_per_cell = 8;
    /// Rows of points that the nodes of a row take, faces and centres together.
    static constexpr int max_rows = 2 * max_per_cell;

    /// A particle of a node (i, j): point (x, y) of the lattice, counted from cell (i, j)'s first one.
    struct Point {
        int x, y;
        Particle particle;
    };

    /// The coarsest lattice that a node's particles form with those of its neighbours at all sites.
    /// @return nothing where there is none, nor for particles in a line or outside of the node's own cell
    static std::optional<Lattice> of(std::span<const Particle> particles);

    int per_cell() const { return per_cell_; }
    /// The particles of a site's nodes, but for one at the node itself.
    std::span<const Point> particles(Site site) const { return sites_[static_cast<int>(site)].particles; }
    /// The point that is a site's node, if there is one.
    const std::optional<Point>& node(Site site) const { return sites_[static_cast<int>(site)].node; }
    /// The lowest and the highest row of points that a site's nodes take, counted as a point's y.
    int lowest(Site site) const { return sites_[static_cast<int>(site)].lowest; }
    int highest(Site site) const { return sites_[static_cast<int>(site)].highest; }
    /// A point by the cell that holds it, counted from the node's, and its way from that cell's centre,
    /// cells.
    struct Origin {
        int i, j;
        Vec2 start;
    };
    Origin origin(const Point& point) const;
    /// From a cell's centre to point (x, y) of its own, in cells.
    Vec2 start(int x, int y) const;

  private:
    Lattice(int per_cell, double phase) : per_cell_(per_cell), phase_(phase) {}
    /// @return false where a particle is not a point of the lattice
    bool place(std::span<const Particle> particles);

    struct Nodes {
        std::vector<Point> particles;
        std::optional<Point> node;
        int lowest = 0, highest = 0;
    };

    int per_cell_;
    double phase_;
    std::array<Nodes, 3> sites_;
};

/// A thread's stretch of lattice: a few rows of points, a tile's width wide, and what they carry.
class LatticeTile {
  public:
    /// Cells across: rows stay in a core's own cache, and with a cell more they are whole spans.
    static constexpr int max_cells = 2 * NodeSpan::size - 1;
    /// A cache line, or a vector register.
    struct alignas(64) Line {
        static constexpr int size = 64 / sizeof(Real);
        Real values[size];
    };

    /// What a node of a group takes: the row of points, counted from the lowest in use, and where in it what
    /// the particle carries to the tile's first node stands.
    struct Source {
        int row;
        std::ptrdiff_t offset;
        const Particle* particle;
    };

    /// Rows of values before those of the fields: the point's own displacement.
    static constexpr int displacement_rows = 2;

    /// Makes room for what a number of fields need; allocates only when it has to grow.
    void shape(const Lattice& lattice, int fields);

    /// What point x (0 … per_cell − 1) of each cell in lattice row y carries: rows of values.
    Real* row(int y, int x) {
        const int slot = ((y % slots_) + slots_) % slots_;
        return lines_.front().values + slot * point(per_cell_) + point(x);
    }
    /// From point 0 to point x of a lattice row.
    std::ptrdiff_t point(int x) const { return static_cast<std::ptrdiff_t>(x) * rows_ * stride; }
    /// From one row of values to the next: as many as lines hold, with a cell on either side and the rest of
    /// a vector; odd in lines, so that rows do not crowd into one set of the cache.
    static constexpr std::ptrdiff_t stride = max_cells + 1 + Line::size;

    /// Room for a source for each particle of a group's node, and for a share.
    std::span<Source> sources(int group) { return sources_[static_cast<std::size_t>(group)]; }
    std::span<Contribution> contributions() { return contributions_; }

  private:
    int slots_ = 1, per_cell_ = 1, rows_ = 0;
    std::vector<Line> lines_;
    std::array<std::vector<Source>, 3> sources_;
    std::vector<Contribution> contributions_;
};

/// Rows [first, last) of a base step whose particles form a lattice: points are traced and sampled once, row
/// by row, and nodes sum what the points around them carry.
void lattice_band(const Step& step, std::span<const Group> groups, Real direction, int first, int last,
                  LatticeTile& tile, Store finish);

}  // namespace whorl
