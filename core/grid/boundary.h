// What bounds the fluid: the domain's sides and the solid cells, and the ghost values that carry their rules.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/grid/field.h"
#include "core/schemes/scheme.h"

namespace whorl {

/// Four free-slip walls.
struct Box {
    static constexpr SchemeInfo info{"box", "Closed box", "", "Four free-slip walls close the domain."};
};
/// Opposite sides are the same place.
struct Periodic {
    static constexpr SchemeInfo info{"periodic", "Periodic", "",
                                     "What leaves on one side comes in on the opposite one."};
};
using Sides = SchemeList<Box, Periodic>;

/// The sides of the domain and a mask of stationary solid cells.
///
/// Free slip: the normal velocity of a solid face is 0; tangential velocity and scalars take the nearest
/// fluid value across the wall (zero gradient). `fill` writes that rule into ghost borders and solid cells,
/// so that sampling needs no special case.
class Boundary {
  public:
    Boundary() = default;
    Boundary(Grid grid, Sides::Id sides);

    const Grid& grid() const { return grid_; }
    bool periodic() const { return periodic_; }
    bool has_solids() const { return solids_ > 0; }
    /// Number of fluid cells.
    int fluid_cells() const { return grid_.nx * grid_.ny - solids_; }

    /// Whether cell (i, j) is solid; outside a box everything is, a periodic index wraps.
    bool solid(int i, int j) const;
    /// Makes cells solid or fluid by `mask` (nx × ny, row by row, non-zero is solid).
    /// @throws std::invalid_argument if the mask has another size.
    void set_solids(std::vector<std::uint8_t> mask);
    const std::vector<std::uint8_t>& solids() const { return mask_; }
    /// Counts the changes of the mask, so that a solver knows when to prepare anew.
    int revision() const { return revision_; }

    /// Whether fluid may cross the face between two cells: both are fluid.
    bool open_x(int i, int j) const { return !solid(i - 1, j) && !solid(i, j); }
    bool open_y(int i, int j) const { return !solid(i, j - 1) && !solid(i, j); }

    /// A field of this domain's shape at a site. In a box a face field has both walls' faces; in a periodic
    /// domain the last face is the first one, and lies in the ghost border.
    Field field(Site site, Real value = 0) const;
    FaceVelocity velocity() const { return {field(Site::FaceX), field(Site::FaceY)}; }

    /// Writes the values of solid cells, closed faces and the ghost border.
    void fill(Field& field) const;
    void fill(FaceVelocity& velocity) const {
        fill(velocity.u);
        fill(velocity.v);
    }
    /// Sets the normal velocity of every closed face to 0, and fills.
    void enforce(FaceVelocity& velocity) const;

    /// Memory that a copy takes.
    std::size_t bytes() const;

  private:
    /// Copies `from` to `to`, both offsets in a field's row-by-row order without ghosts.
    struct Copy {
        int to;
        int from;
    };
    struct SolidRule {
        std::vector<Copy> nearest;  ///< samples inside solids and the nearest sample that fluid touches
        std::vector<int> closed;    ///< faces with fluid on one side only: normal velocity 0
    };

    SolidRule make_rule(Site site) const;
    const SolidRule& rule(Site site) const { return rules_[static_cast<int>(site)]; }
    std::pair<int, int> shape(Site site) const;

    Grid grid_;
    bool periodic_ = false;
    int solids_ = 0;
    int revision_ = 0;
    std::vector<std::uint8_t> mask_;
    std::array<SolidRule, 3> rules_;
};

}  // namespace whorl
