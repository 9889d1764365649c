// The outer iteration of conjugate gradient, whatever preconditions it and however its vectors are held.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/stopwatch.h"
#include "core/pressure/poisson.h"
#include "core/pressure/solver.h"

namespace whorl {

/// Solves A p = b to `enough`, from the guess in p or from 0 where that is nearer.  [T sec. 2.2]
///
/// The residual r is kept near 1, by a power of 2, so that neither squares overflow nor floats vanish
/// whatever b's unit.
/// @param r     scratch as large as b; the residual of the scaled system while it runs
/// @param most  iterations after which it stops whatever is left
/// @param way   precondition(): z ≈ A⁻¹ r, gives r·z;  search(beta): s = z + beta s, gives s·A s;
///              descend(alpha, gain): r −= alpha A s, p += gain s, gives max |r|
template <class Way>
SolveReport iterate(const Poisson& poisson, std::span<const double> b, double enough, std::span<double> p,
                    std::vector<double>& r, int most, Pool& pool, Way&& way) {
    const Stopwatch watch;
    SolveReport report;
    const double largest = poisson.largest(b, pool);
    if (!(largest > 0)) {
        std::fill(p.begin(), p.end(), 0.0);
        return report;
    }
    const double scale = std::exp2(-std::ilogb(largest));
    double peak = poisson.residual(b, p, scale, r, pool);
    if (!(peak <= scale * largest)) {  // the guess is worse than none
        std::fill(p.begin(), p.end(), 0.0);
        peak = poisson.residual(b, p, scale, r, pool);
    }
    double before = 0;
    while (peak > scale * enough && report.iterations < most) {
        const double along = way.precondition();
        const double energy = way.search(before > 0 ? along / before : 0);
        if (!(energy > 0)) break;
        const double alpha = along / energy;
        peak = way.descend(alpha, alpha / scale);
        before = along;
        ++report.iterations;
    }
    report.residual = peak / (scale * largest);
    report.solve_ms = watch.ms();
    return report;
}

}  // namespace whorl
