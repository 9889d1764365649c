#include "core/pressure/conjugate_gradient.h"

#include <cmath>

#include "core/pressure/preconditioned_iteration.h"
#include "core/pressure/vector_clones.h"

namespace whorl {
namespace {

/// How much of the dropped fill-in moves to the diagonal, and the part of a diagonal entry below which it is
/// taken whole instead.  [Bridson 2015, fig. 5.5]
constexpr double tau = 0.97;
constexpr double sigma = 0.25;
/// Enough for 4096² cells without obstacles; reached only by a tolerance below rounding.
constexpr int most_iterations = 3000;

WHORL_VECTOR_CLONES
double dot(const double* __restrict x, const double* __restrict y, int n) {
    constexpr int lanes = 8;
    double lane[lanes] = {};
    int i = 0;
    for (; i + lanes <= n; i += lanes) {
        for (int k = 0; k < lanes; ++k) lane[k] += x[i + k] * y[i + k];
    }
    for (int k = 0; i < n; ++i, ++k) lane[k] += x[i] * y[i];
    return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

/// y += a x
WHORL_VECTOR_CLONES
void add(double a, const double* __restrict x, double* __restrict y, int n) {
    for (int i = 0; i < n; ++i) y[i] += a * x[i];
}

/// y = x + a y
WHORL_VECTOR_CLONES
void scale_and_add(const double* __restrict x, double a, double* __restrict y, int n) {
    for (int i = 0; i < n; ++i) y[i] = x[i] + a * y[i];
}

}  // namespace

void ConjugateGradient::prepare(const Boundary& boundary, Pool& pool) {
    const Stopwatch watch;
    poisson_.prepare(boundary, pool);
    const int nx = poisson_.nx();
    const int ny = poisson_.ny();
    const std::size_t cells = static_cast<std::size_t>(nx) * ny;
    for (std::vector<double>* values :
         {&root_, &west_, &south_, &east_, &north_, &r_, &z_, &direction_, &product_, &zeros_})
        values->assign(cells, 0);

    const auto fluid = [&](int i, int j) {
        return i < nx && j < ny && boundary.solids()[static_cast<std::size_t>(j) * nx + i] == 0;
    };
    std::vector<double>& root = root_;  // Bridson's precon
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const std::size_t c = static_cast<std::size_t>(j) * nx + i;
            const double diagonal = poisson_.degrees(j)[i];
            if (!(diagonal > 0)) continue;
            double e = diagonal;
            if (i > 0 && fluid(i - 1, j)) {
                const double w = root[c - 1] * root[c - 1];
                e -= w * (1 + (fluid(i - 1, j + 1) ? tau : 0));
            }
            if (j > 0 && fluid(i, j - 1)) {
                const double s = root[c - nx] * root[c - nx];
                e -= s * (1 + (fluid(i + 1, j - 1) ? tau : 0));
            }
            if (e < sigma * diagonal) e = diagonal;
            root[c] = 1 / std::sqrt(e);
        }
    }
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const std::size_t c = static_cast<std::size_t>(j) * nx + i;
            if (!(root_[c] > 0)) continue;
            const double square = root_[c] * root_[c];
            if (i > 0) west_[c] = root_[c] * root_[c - 1];
            if (j > 0) south_[c] = root_[c] * root_[c - nx];
            if (i + 1 < nx && fluid(i + 1, j)) east_[c] = square;
            if (j + 1 < ny && fluid(i, j + 1)) north_[c] = square;
        }
    }
    setup_ms_ = watch.ms();
}

/// z = (L Lᵀ)⁻¹ r. L has 1 / root on its diagonal and −root of the cell on its left or below beside it, so
/// that root L has 1 on the diagonal, and −west and −south: both solves are a vector loop and a short
/// recurrence.
void ConjugateGradient::precondition() {
    const int nx = poisson_.nx();
    const int ny = poisson_.ny();
    for (int j = 0; j < ny; ++j) {
        const std::size_t at = static_cast<std::size_t>(j) * nx;
        double* q = z_.data() + at;
        const double* root = root_.data() + at;
        const double* r = r_.data() + at;
        for (int i = 0; i < nx; ++i) q[i] = root[i] * r[i];
        if (j > 0) {
            const double* south = south_.data() + at;
            for (int i = 0; i < nx; ++i) q[i] += south[i] * q[i - nx];
        }
        const double* west = west_.data() + at;
        for (int i = 1; i < nx; ++i) q[i] += west[i] * q[i - 1];
    }
    // Lᵀ z = q: z = root q + root² (z east + z north), with L's entries towards this cell, −root.
    for (int j = ny - 1; j >= 0; --j) {
        const std::size_t at = static_cast<std::size_t>(j) * nx;
        double* q = z_.data() + at;
        const double* root = root_.data() + at;
        const double* north = north_.data() + at;
        for (int i = 0; i < nx; ++i) q[i] *= root[i];
        if (j + 1 < ny) {
            for (int i = 0; i < nx; ++i) q[i] += north[i] * q[i + nx];
        }
        const double* east = east_.data() + at;
        for (int i = nx - 2; i >= 0; --i) q[i] += east[i] * q[i + 1];
    }
}

SolveReport ConjugateGradient::solve(std::span<const double> b, double enough, std::span<double> p,
                                     Pool& pool) {
    struct Way {
        ConjugateGradient& self;
        std::span<double> p;
        Pool& pool;
        int n = static_cast<int>(p.size());

        double precondition() {
            self.precondition();
            return dot(self.r_.data(), self.z_.data(), n);
        }
        double search(double beta) {
            scale_and_add(self.z_.data(), beta, self.direction_.data(), n);
            self.poisson_.residual(self.zeros_, self.direction_, -1, self.product_, pool);
            return dot(self.direction_.data(), self.product_.data(), n);
        }
        double descend(double alpha, double gain) {
            add(gain, self.direction_.data(), p.data(), n);
            add(-alpha, self.product_.data(), self.r_.data(), n);
            return self.poisson_.largest(self.r_, pool);
        }
    };
    SolveReport report = iterate(poisson_, b, enough, p, r_, most_iterations, pool, Way{*this, p, pool});
    report.solver = info.key;
    report.setup_ms = setup_ms_;
    return report;
}

}  // namespace whorl
