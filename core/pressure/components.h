// The connected components of the fluid, each of which has a pressure of its own.
#pragma once

#include <span>
#include <vector>

#include "core/grid/boundary.h"

namespace whorl {

/// Fluid cells that are connected through open faces share a label, 0 … count − 1; solid cells have −1.
class Components {
  public:
    explicit Components(const Boundary& boundary);
    Components() = default;

    int count() const { return static_cast<int>(cells_.size()); }
    /// nx × ny labels, row by row.
    std::span<const int> labels() const { return labels_; }

    /// Subtracts from each component its mean, and zeroes solid cells.
    /// @return the largest mean that was removed, by size
    double remove_means(std::span<double> values) const;

  private:
    std::vector<int> labels_;
    std::vector<int> cells_;  ///< cells of each component
    mutable std::vector<double> sums_;
};

}  // namespace whorl
