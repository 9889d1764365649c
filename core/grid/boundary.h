// What bounds the fluid: the domain's sides and the solid cells, and the ghost values that carry their rules.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/grid/field.h"
#include "core/grid/sides.h"

namespace whorl {

/// The sides of the domain and a mask of stationary solid cells.
///
/// Free slip: the normal velocity of a solid face is 0; tangential velocity and scalars take the nearest
/// fluid value across the wall (zero gradient). `fill` writes that rule into ghost borders and solid cells,
/// so that sampling needs no special case.
class Boundary {
  public:
    Boundary() = default;
    /// @throws std::invalid_argument if a side wraps and the opposite one does not, or has conditions other
    /// than a free-slip wall's
    Boundary(Grid grid, const Sides& sides);

    const Grid& grid() const { return grid_; }
    const Sides& sides() const { return sides_; }
    Wraps wraps() const { return sides_.wraps(); }
    bool has_solids() const { return solids_ > 0; }
    /// Number of fluid cells.
    int fluid_cells() const { return grid_.nx * grid_.ny - solids_; }

    /// Whether cell (i, j) is solid, as is all that lies beyond a wall. Beyond a side that wraps, indices do.
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

    /// A field of this domain's shape at a site. A face field has the faces of both sides that it crosses;
    /// where they wrap, the last face is the first one, and lies in the ghost border.
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

    /// Whether (i, j) lies within nx × ny, once indices have wrapped where sides do.
    bool inside(int& i, int& j, int nx, int ny) const;
    SolidRule make_rule(Site site) const;
    const SolidRule& rule(Site site) const { return rules_[static_cast<int>(site)]; }
    std::pair<int, int> shape(Site site) const;

    Grid grid_;
    Sides sides_;
    int solids_ = 0;
    int revision_ = 0;
    std::vector<std::uint8_t> mask_;
    std::array<SolidRule, 3> rules_;
};

}  // namespace whorl
