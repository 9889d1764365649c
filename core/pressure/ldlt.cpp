#include "core/pressure/ldlt.h"

#include <Eigen/SparseCholesky>
#include <chrono>
#include <stdexcept>

#include "core/pressure/components.h"
#include "core/pressure/residual.h"

namespace whorl {

struct Ldlt::Factor {
    Boundary boundary;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> ldlt;
    std::vector<int> row_of_cell;  ///< −1 for solid and pinned cells
    Eigen::VectorXd right, solution;
    double setup_ms = 0;
};

Ldlt::Ldlt() = default;
Ldlt::~Ldlt() = default;

void Ldlt::prepare(const Boundary& boundary, Pool&) {
    const auto start = std::chrono::steady_clock::now();
    factor_ = std::make_unique<Factor>();
    factor_->boundary = boundary;
    const int nx = boundary.grid().nx;
    const int ny = boundary.grid().ny;
    const Components components(boundary);

    std::vector<int>& row = factor_->row_of_cell;
    row.assign(static_cast<std::size_t>(nx) * ny, -1);
    std::vector<bool> pinned(components.count(), false);
    int rows = 0;
    for (int c = 0; c < nx * ny; ++c) {
        const int label = components.labels()[c];
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
    factor_->right.setZero(rows);
    factor_->solution.setZero(rows);
    if (rows > 0) {
        factor_->ldlt.compute(matrix);
        if (factor_->ldlt.info() != Eigen::Success)
            throw std::runtime_error("the pressure matrix has no LDLT factor");
    }
    factor_->setup_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

SolveReport Ldlt::solve(std::span<const double> b, std::span<double> p, Pool&) {
    const auto start = std::chrono::steady_clock::now();
    Factor& f = *factor_;
    for (std::size_t c = 0; c < b.size(); ++c) {
        if (f.row_of_cell[c] >= 0) f.right[f.row_of_cell[c]] = b[c];
    }
    if (f.right.size() > 0) f.solution = f.ldlt.solve(f.right);
    for (std::size_t c = 0; c < p.size(); ++c)
        p[c] = f.row_of_cell[c] >= 0 ? f.solution[f.row_of_cell[c]] : 0;
    SolveReport report;
    report.setup_ms = f.setup_ms;
    report.solve_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    report.residual = relative_residual(f.boundary, b, p);
    return report;
}

}  // namespace whorl
