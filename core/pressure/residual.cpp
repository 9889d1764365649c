#include "core/pressure/residual.h"

#include <algorithm>
#include <cmath>

namespace whorl {

double relative_residual(const Boundary& boundary, std::span<const double> b, std::span<const double> p) {
    const int nx = boundary.grid().nx;
    const int ny = boundary.grid().ny;
    double worst = 0;
    double largest = 0;
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            if (boundary.solid(i, j)) continue;
            const int c = j * nx + i;
            double r = b[c];
            if (boundary.open_x(i, j)) r -= p[c] - p[j * nx + (i + nx - 1) % nx];
            if (boundary.open_x(i + 1, j)) r -= p[c] - p[j * nx + (i + 1) % nx];
            if (boundary.open_y(i, j)) r -= p[c] - p[(j + ny - 1) % ny * nx + i];
            if (boundary.open_y(i, j + 1)) r -= p[c] - p[(j + 1) % ny * nx + i];
            worst = std::max(worst, std::abs(r));
            largest = std::max(largest, std::abs(b[c]));
        }
    }
    return largest > 0 ? worst / largest : 0;
}

}  // namespace whorl
