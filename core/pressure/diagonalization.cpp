#include "core/pressure/diagonalization.h"

#include <algorithm>

#include "core/base/stopwatch.h"
#include "core/pressure/gemm.h"

namespace whorl {
namespace {

/// Rows of a matrix start in different cache sets.
constexpr int skew = 8;
/// Rows that are transformed at a time: the panels of the modes are read once for them.
constexpr int rows_at_a_time = 24;

std::vector<double> strided(const std::vector<double>& matrix, int count, int stride, bool transposed) {
    std::vector<double> out(static_cast<std::size_t>(count) * stride, 0);
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < count; ++k)
            out[static_cast<std::size_t>(i) * stride + k] =
                matrix[static_cast<std::size_t>(transposed ? k : i) * count + (transposed ? i : k)];
    }
    return out;
}

}  // namespace

std::string_view Diagonalization::unsupported_reason(const Boundary& boundary) {
    return boundary.has_solids() ? "obstacles: the modes of an obstructed domain are no products of waves"
                                 : std::string_view{};
}

int Diagonalization::Half::panels() const {
    return padded_to_panel(count) / panel_width;
}

void Diagonalization::Direction::prepare(int n, bool wraps) {
    if (cells == n && periodic == wraps) return;
    cells = n;
    periodic = wraps;
    const Modes both = modes(n, wraps);
    for (const auto& [half, set] : {std::pair(&even, &both.even), std::pair(&odd, &both.odd)}) {
        half->count = set->count;
        half->stride = padded_to_panel(set->count) + skew;
        half->to_modes = strided(set->values, set->count, half->stride, true);
        half->to_cells = strided(set->values, set->count, half->stride, false);
        half->modes_of_row = panels_of(set->values, set->count, set->count);
        half->cells_of_modes =
            panels_of(strided(set->values, set->count, set->count, true), set->count, set->count);
        half->eigenvalues = set->eigenvalues;
    }
}

void Diagonalization::prepare(const Boundary& boundary, Pool& pool) {
    const Stopwatch watch;
    poisson_.prepare(boundary, pool);
    x_.prepare(poisson_.nx(), poisson_.wraps_x());
    y_.prepare(poisson_.ny(), poisson_.wraps_y());
    stride_ = (x_.even.panels() + x_.odd.panels()) * panel_width + skew;
    folded_.assign(static_cast<std::size_t>(stride_) * poisson_.ny(), 0);
    modes_.assign(folded_.size(), 0);
    columns_.assign(
        static_cast<std::size_t>(2) * poisson_.ny() * panel_width * (x_.even.panels() + x_.odd.panels()), 0);
    setup_ms_ = watch.ms();
}

void Diagonalization::rows_to_modes(const double* b, int begin, int end) {
    const int nx = x_.cells;
    const int odd_at = x_.even.panels() * panel_width;
    for (int j = begin; j < end; ++j) {
        const double* row = b + static_cast<std::size_t>(j) * nx;
        double* even = folded_.data() + static_cast<std::size_t>(j) * stride_;
        double* odd = even + odd_at;
        for (int i = 0; i < x_.odd.count; ++i) {
            even[i] = row[i] + row[nx - 1 - i];
            odd[i] = row[i] - row[nx - 1 - i];
        }
        if (x_.even.count > x_.odd.count) even[x_.odd.count] = row[x_.odd.count];
    }
    const std::size_t at = static_cast<std::size_t>(begin) * stride_;
    for (const auto& [half, column] : {std::pair(&x_.even, 0), std::pair(&x_.odd, odd_at)}) {
        for (int k = 0; k < half->panels(); ++k)
            multiply(folded_.data() + at + column, stride_,
                     half->modes_of_row.data() + static_cast<std::size_t>(k) * half->count * panel_width,
                     half->count, modes_.data() + at + column + k * panel_width, stride_, end - begin);
    }
}

/// Columns to their modes, divided by the eigenvalues, and back.
/// @param folded room for 2 ny rows of a panel
void Diagonalization::solve_panel(int panel, double* folded) {
    const int ny = y_.cells;
    const bool is_even = panel < x_.even.panels();
    const Half& x = is_even ? x_.even : x_.odd;
    const int first = (is_even ? panel : panel - x_.even.panels()) * panel_width;
    double* column = modes_.data() + static_cast<std::size_t>(panel) * panel_width;
    double* even = folded;
    double* odd = folded + static_cast<std::size_t>(y_.even.count) * panel_width;
    double* waves = folded + static_cast<std::size_t>(ny) * panel_width;

    for (int j = 0; j < y_.odd.count; ++j) {
        const double* low = column + static_cast<std::size_t>(j) * stride_;
        const double* high = column + static_cast<std::size_t>(ny - 1 - j) * stride_;
        for (int c = 0; c < panel_width; ++c) {
            even[j * panel_width + c] = low[c] + high[c];
            odd[j * panel_width + c] = low[c] - high[c];
        }
    }
    if (y_.even.count > y_.odd.count)
        std::copy_n(column + static_cast<std::size_t>(y_.odd.count) * stride_, panel_width,
                    even + y_.odd.count * panel_width);
    double lambda[panel_width];
    for (int c = 0; c < panel_width; ++c) lambda[c] = first + c < x.count ? x.eigenvalues[first + c] : 1;
    for (const auto& [half, part] : {std::pair(&y_.even, even), std::pair(&y_.odd, odd)}) {
        multiply(half->to_modes.data(), half->stride, part, half->count, waves, panel_width, half->count);
        for (int k = 0; k < half->count; ++k) {
            for (int c = 0; c < panel_width; ++c) {
                const double sum = lambda[c] + half->eigenvalues[k];
                // The constant is in no equation: it stays 0.
                waves[k * panel_width + c] = sum > 0 ? waves[k * panel_width + c] / sum : 0;
            }
        }
        multiply(half->to_cells.data(), half->stride, waves, half->count, part, panel_width, half->count);
    }
    for (int j = 0; j < y_.odd.count; ++j) {
        double* low = column + static_cast<std::size_t>(j) * stride_;
        double* high = column + static_cast<std::size_t>(ny - 1 - j) * stride_;
        for (int c = 0; c < panel_width; ++c) {
            low[c] = even[j * panel_width + c] + odd[j * panel_width + c];
            high[c] = even[j * panel_width + c] - odd[j * panel_width + c];
        }
    }
    if (y_.even.count > y_.odd.count)
        std::copy_n(even + y_.odd.count * panel_width, panel_width,
                    column + static_cast<std::size_t>(y_.odd.count) * stride_);
}

void Diagonalization::rows_to_cells(double* p, int begin, int end) {
    const int nx = x_.cells;
    const int odd_at = x_.even.panels() * panel_width;
    const std::size_t at = static_cast<std::size_t>(begin) * stride_;
    for (const auto& [half, column] : {std::pair(&x_.even, 0), std::pair(&x_.odd, odd_at)}) {
        for (int k = 0; k < half->panels(); ++k)
            multiply(modes_.data() + at + column, stride_,
                     half->cells_of_modes.data() + static_cast<std::size_t>(k) * half->count * panel_width,
                     half->count, folded_.data() + at + column + k * panel_width, stride_, end - begin);
    }
    for (int j = begin; j < end; ++j) {
        double* row = p + static_cast<std::size_t>(j) * nx;
        const double* even = folded_.data() + static_cast<std::size_t>(j) * stride_;
        const double* odd = even + odd_at;
        for (int i = 0; i < x_.odd.count; ++i) {
            row[i] = even[i] + odd[i];
            row[nx - 1 - i] = even[i] - odd[i];
        }
        if (x_.even.count > x_.odd.count) row[x_.odd.count] = even[x_.odd.count];
    }
}

SolveReport Diagonalization::solve(std::span<const double> b, double, std::span<double> p, Pool& pool) {
    const Stopwatch watch;
    const int ny = y_.cells;
    const auto over_rows = [&](auto&& work) {
        pool.bands((ny + rows_at_a_time - 1) / rows_at_a_time, [&](int begin, int end) {
            for (int unit = begin; unit < end; ++unit)
                work(unit * rows_at_a_time, std::min((unit + 1) * rows_at_a_time, ny));
        });
    };
    over_rows([&](int begin, int end) { rows_to_modes(b.data(), begin, end); });
    pool.bands(x_.even.panels() + x_.odd.panels(), [&](int begin, int end) {
        double* folded = columns_.data() + static_cast<std::size_t>(2) * ny * panel_width * begin;
        for (int panel = begin; panel < end; ++panel) solve_panel(panel, folded);
    });
    over_rows([&](int begin, int end) { rows_to_cells(p.data(), begin, end); });
    SolveReport report;
    report.solver = info.key;
    report.setup_ms = setup_ms_;
    report.solve_ms = watch.ms();
    report.residual = relative_residual(poisson_, b, p, pool);
    return report;
}

}  // namespace whorl
