// How much each particle of an ASLAM node counts, by its distance r from it; Δ_r = ½√d cells.  [T 4.4–4.9]
#pragma once

#include <cmath>

#include "core/schemes/scheme.h"

namespace whorl {

struct UniformWeights {
    static constexpr SchemeInfo info{"uniform", "Uniform", "thesis eq. 4.4",
                                     "Every particle counts the same."};
    static double weight(double, double) { return 1; }
};
struct SphWeights {
    static constexpr SchemeInfo info{
        "sph", "SPH", "Müller et al. 2003; thesis eq. 4.5",
        "The smoothing kernel of particle hydrodynamics: the node counts the most."};
    static constexpr double kappa = 1.5;
    static double weight(double r, double radius) {
        const double a = kappa * radius * kappa * radius - r * r;
        return a * a * a;
    }
};
struct GaussianWeights {
    static constexpr SchemeInfo info{"gaussian", "Gaussian", "thesis eq. 4.8–4.9",
                                     "A bell of deviation 0.75, between uniform and SPH."};
    static constexpr double sigma = 0.75;
    static double weight(double r, double radius) {
        return std::exp(-(r / radius) * (r / radius) / (2 * sigma * sigma));
    }
};

}  // namespace whorl
