#include "core/pressure/ldlt.h"

#include <Eigen/SparseCholesky>
#include <stdexcept>

#include "core/base/stopwatch.h"
#include "core/pressure/components.h"
#include "core/pressure/poisson.h"

namespace whorl {

struct Ldlt::Factor {
    Poisson poisson;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> ldlt;
    std::vector<int> row_of_cell;  ///< in the factor's order; −1 for solid and pinned cells
    Eigen::VectorXd solution;
    double setup_ms = 0;
};

Ldlt::Ldlt() = default;
Ldlt::~Ldlt() = default;

void Ldlt::prepare(const Boundary& boundary, Pool& pool) {
    const Stopwatch watch;
    factor_ = std::make_unique<Factor>();
    factor_->poisson.prepare(boundary, pool);
    const int nx = boundary.grid().nx;
    const int ny = boundary.grid().ny;
    const Components components(boundary);

    std::vector<int>& row = factor_->row_of_cell;
    row.assign(static_cast<std::size_t>(nx) * ny, -1);
    std::vector<bool> pinned(components.count(), false);
    int rows = 0;
    for (int c = 0; c < nx * ny; ++c) {
        const int label = components.label(c);
        if (label < 0) continue;
        if (!pinned[label]) {
            pinned[label] = true;
        } else {
            row[c] = rows++;
        }
    }

    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(rows) * 5);
    const auto face = [&](int c, int n) {
        if (c == n) return;  // a periodic domain one cell wide: the face leads back to its own cell
        if (row[c] >= 0) entries.emplace_back(row[c], row[c], 1.0);
        if (row[n] >= 0) entries.emplace_back(row[n], row[n], 1.0);
        if (row[c] >= 0 && row[n] >= 0)
            entries.emplace_back(std::max(row[c], row[n]), std::min(row[c], row[n]), -1.0);
    };
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int c = j * nx + i;
            if (boundary.open_x(i, j)) face(c, j * nx + (i + nx - 1) % nx);
            if (boundary.open_y(i, j)) face(c, (j + ny - 1) % ny * nx + i);
        }
    }
    Eigen::SparseMatrix<double> matrix(rows, rows);
    matrix.setFromTriplets(entries.begin(), entries.end());
    factor_->solution.setZero(rows);
    if (rows > 0) {
        factor_->ldlt.compute(matrix);
        if (factor_->ldlt.info() != Eigen::Success)
            throw std::runtime_error("the pressure matrix has no LDLT factor");
        const auto& order = factor_->ldlt.permutationP().indices();
        for (int& r : row) r = r >= 0 && order.size() > 0 ? order[r] : r;
    }
    factor_->setup_ms = watch.ms();
}

std::size_t Ldlt::factor_entries() const {
    if (factor_->solution.size() == 0) return 0;
    return static_cast<std::size_t>(factor_->ldlt.matrixL().nestedExpression().nonZeros());
}

SolveReport Ldlt::solve(std::span<const double> b, double, std::span<double> p, Pool& pool) {
    const Stopwatch watch;
    Factor& f = *factor_;
    // In the factor's own order, in place: Eigen's solve() would allocate to permute.
    for (std::size_t c = 0; c < b.size(); ++c) {
        if (f.row_of_cell[c] >= 0) f.solution[f.row_of_cell[c]] = b[c];
    }
    if (f.solution.size() > 0) {
        f.ldlt.matrixL().solveInPlace(f.solution);
        f.solution.array() /= f.ldlt.vectorD().array();
        f.ldlt.matrixU().solveInPlace(f.solution);
    }
    for (std::size_t c = 0; c < p.size(); ++c)
        p[c] = f.row_of_cell[c] >= 0 ? f.solution[f.row_of_cell[c]] : 0;
    SolveReport report;
    report.solver = info.key;
    report.setup_ms = f.setup_ms;
    report.solve_ms = watch.ms();
    report.residual = relative_residual(f.poisson, b, p, pool);
    return report;
}

}  // namespace whorl
