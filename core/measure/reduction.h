// Sums over the fluid's cells that a measure is worked out from.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/parallel/pool.h"
#include "core/scene/state.h"

namespace whorl {

struct Measure;

/// As many sums as a measure has use for.
using Sums = std::array<double, 8>;

/// The sums of one measure.
struct Reduced {
    const Measure* measure = nullptr;
    Sums sums{};
};

/// The columns of a row's fluid cells, in order.
class FluidCells {
  public:
    class Iterator {
      public:
        Iterator(const std::uint8_t* solid, int i, int end) : solid_(solid), i_(i), end_(end) { skip(); }
        int operator*() const { return i_; }
        Iterator& operator++() {
            ++i_;
            skip();
            return *this;
        }
        bool operator==(const Iterator& other) const { return i_ == other.i_; }

      private:
        void skip() {
            while (i_ < end_ && solid_[i_] != 0) ++i_;
        }
        const std::uint8_t* solid_;
        int i_, end_;
    };

    FluidCells(const std::uint8_t* solid, int width) : solid_(solid), width_(width) {}
    Iterator begin() const { return {solid_, 0, width_}; }
    Iterator end() const { return {solid_, width_, width_}; }

  private:
    const std::uint8_t* solid_;
    int width_;
};

/// A row of cells; samples are by column.
struct RowView {
    const State& state;
    int j;
    double y;                           ///< of the cells' centres, length
    double h;                           ///< cell size, length
    const Real *density, *temperature;  ///< at centres
    const Real *u, *v_below,
        *v_above;  ///< at the left faces, i and i + 1 of a cell, and at the lower and upper ones

    /// The samples of any field in row j.
    const Real* of(FieldId id) const { return state[id].row(j); }
    /// The columns of the cells to add.
    FluidCells fluid() const {
        const int nx = state.grid().nx;
        return {state.boundary.solids().data() + static_cast<std::ptrdiff_t>(j) * nx, nx};
    }
    /// Of a column's centre, length.
    double x(int i) const { return (i + 0.5) * h; }
};

/// Adds up measures that have a `row` in one pass over the cells; rows are added in order, so that threads do
/// not change the result. Keeps its scratch.
class Reducer {
  public:
    /// @param reduced  measures with a `row`; their sums on return
    void reduce(const State& state, Pool& pool, std::vector<Reduced>& reduced);

  private:
    std::vector<Sums> rows_;  // of each row and measure
};

}  // namespace whorl
