#include "core/pressure/multigrid.h"

#include <algorithm>

#include "core/parallel/row_bands.h"
#include "core/pressure/multigrid_cycle.h"
#include "core/pressure/poisson_rows.h"
#include "core/pressure/preconditioned_iteration.h"

namespace whorl {
namespace {

/// Discs need 7, mazes of thin walls 40; noise at the edge of percolation needs hundreds.
constexpr int most_iterations = 2000;

}  // namespace

void Multigrid::prepare(const Boundary& boundary, Pool& pool) {
    const Stopwatch watch;
    poisson_.prepare(boundary, pool);
    levels_.prepare(boundary, poisson_, pool);
    const int nx = poisson_.nx();
    const int ny = poisson_.ny();
    r_.assign(static_cast<std::size_t>(nx) * ny, 0);
    direction_.resize(nx, ny);
    next_direction_.resize(nx, ny);
    row_sums_.assign(static_cast<std::size_t>(ny), 0);
    setup_ms_ = watch.ms();
}

SolveReport Multigrid::solve(std::span<const double> b, double enough, std::span<double> p, Pool& pool) {
    struct Way {
        Multigrid& self;
        std::span<double> p;
        Pool& pool;

        double precondition() { return self.precondition(pool); }
        double search(double beta) { return self.search(static_cast<float>(beta), pool); }
        double descend(double alpha, double gain) { return self.descend(alpha, gain, p, pool); }
    };
    SolveReport report = iterate(poisson_, b, enough, p, r_, most_iterations, pool, Way{*this, p, pool});
    report.solver = info.key;
    report.setup_ms = setup_ms_;
    return report;
}

/// z ≈ A⁻¹ r.
/// @return r·z
double Multigrid::precondition(Pool& pool) {
    levels_.fine.b = r_.data();
    v_cycle(levels_, pool);
    double sum = 0;
    for (const double row : levels_.fine.row_dots) sum += row;
    return sum;
}

/// s = z + beta s, in new rows, for a band needs the old ones beside it.
/// @return s·A s
double Multigrid::search(float beta, Pool& pool) {
    const LevelShape& shape = levels_.fine.shape;
    PaddedRows& scratch = levels_.fine.work.scratch;
    const PaddedRows& z = levels_.fine.work.whole;
    const int units = (shape.ny + rows_of_unit - 1) / rows_of_unit;
    pool.bands(units, [&](int begin_unit, int end_unit) {
        const int begin = begin_unit * rows_of_unit;
        const int end = std::min(end_unit * rows_of_unit, shape.ny);
        const int first_scratch = begin_unit * rows_of_scratch;
        const auto at = [&](int t) {
            return t >= begin && t < end ? next_direction_.row(t) : scratch.row(first_scratch + (t & 3));
        };
        for (int t = begin - 1; t <= end; ++t) {
            const int j = shape.row(t);
            float* out = at(t);
            if (j < 0) {
                std::fill(out - 1, out + shape.nx + 1, 0.0F);
            } else {
                rows::combine(z.row(j), beta, direction_.row(j), out, shape.nx);
                border(out, shape.nx, shape.wraps_x);
            }
            if (t <= begin) continue;
            row_sums_[t - 1] = rows::energy(poisson_.degrees(t - 1), at(t - 2), at(t - 1), at(t), shape.nx);
        }
    });
    std::swap(direction_, next_direction_);
    double sum = 0;
    for (const double row : row_sums_) sum += row;
    return sum;
}

/// r −= alpha A s, p += gain s.
/// @return max |r|
double Multigrid::descend(double alpha, double gain, std::span<double> p, Pool& pool) {
    const LevelShape& shape = levels_.fine.shape;
    const float* none = levels_.fine.work.scratch.row(rows_of_scratch - 1);
    std::fill_n(levels_.fine.work.scratch.row(rows_of_scratch - 1), shape.nx, 0.0F);
    const auto row = [&](int t) {
        const int j = shape.row(t);
        return j < 0 ? none : direction_.row(j);
    };
    row_bands(pool, shape.nx, shape.ny, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            const std::size_t at = static_cast<std::size_t>(j) * shape.nx;
            row_sums_[j] = rows::descend(poisson_.degrees(j), row(j - 1), row(j), row(j + 1), alpha, gain,
                                         r_.data() + at, p.data() + at, shape.nx);
        }
    });
    double most = 0;
    for (const double value : row_sums_) most = std::max(most, value);
    return most;
}

}  // namespace whorl
