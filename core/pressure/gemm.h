// A dense matrix product, for as many columns as fit a vector register or two.
#pragma once

#include <vector>

namespace whorl {

/// Columns that are multiplied at a time.
constexpr int panel_width = 16;

constexpr int padded_to_panel(int n) {
    return (n + panel_width - 1) / panel_width * panel_width;
}

/// out = left × panel, where `left` is rows × inner (a row each `left_stride`), `panel` is inner ×
/// panel_width without gaps, and `out` has a row each `out_stride`. Sums run over `inner` in order, a product
/// and a sum at a time, so that results are the same bits with any vector unit and any split of the rows.
void multiply(const double* left, int left_stride, const double* panel, int inner, double* out,
              int out_stride, int rows);

/// The columns of an inner × columns matrix as consecutive panels; the last one is filled up with zeros.
std::vector<double> panels_of(const std::vector<double>& matrix, int inner, int columns);

}  // namespace whorl
