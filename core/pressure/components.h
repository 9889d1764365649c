// The connected components of the fluid, each of which has a pressure of its own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/grid/boundary.h"
#include "core/parallel/pool.h"

namespace whorl {

/// Fluid cells that are connected through open faces share a label, 0 … count − 1; solid cells have −1.
class Components {
  public:
    Components() = default;
    explicit Components(const Boundary& boundary);

    int count() const { return static_cast<int>(cells_.size()); }
    /// @param cell counted row by row
    int label(int cell) const { return labels_[cell]; }

    /// Subtracts from each component its mean, and zeroes solid cells. Allocates nothing; the same bits with
    /// any number of threads.
    /// @return the largest mean that was removed, by size
    double remove_means(std::span<double> values, Pool& pool) const;

  private:
    void find_runs(const Boundary& boundary, std::vector<int>& parents);
    void list_small();

    int nx_ = 0;
    int ny_ = 0;
    std::vector<int> labels_;
    std::vector<int> cells_;          ///< cells of each component
    int largest_ = 0;                 ///< the component of most cells
    std::vector<int> small_;          ///< the cells of all other components: few, in most domains
    std::vector<std::uint8_t> keep_;  ///< 1 in cells of the largest component, else 0
    mutable std::vector<double> sums_, row_sums_, small_values_;
};

}  // namespace whorl
