#include "app/labs/field_sampling.h"

#include <algorithm>
#include <cmath>

#include "core/advection/kernels.h"

namespace whorl::app {

void sample_field(const Field& field, const SchemeSet& schemes, Wraps wraps,
                  std::span<const glm::dvec2> places, std::span<float> out) {
    const Kernels kernels = choose_kernels(schemes, wraps);
    Displacements way;
    CellPositions found;
    alignas(64) Values values;
    for (std::size_t first = 0; first < places.size(); first += NodeSpan::size) {
        const std::size_t count = std::min<std::size_t>(NodeSpan::size, places.size() - first);
        // Displaced from nodes that lie near, so that no digit is lost.
        const glm::dvec2 near = places[first];
        const NodeSpan run{static_cast<int>(std::floor(near.x)), static_cast<int>(std::floor(near.y)),
                           static_cast<int>(count)};
        for (std::size_t k = 0; k < NodeSpan::size; ++k) {
            const glm::dvec2 at = places[first + std::min(k, count - 1)];
            way.x[k] = static_cast<Real>(at.x - (run.i + static_cast<double>(k)));
            way.y[k] = static_cast<Real>(at.y - run.j);
        }
        kernels.locate(field, field.site(), run, way.x, way.y, found);
        kernels.sample(field, found, run.count, values);
        for (std::size_t k = 0; k < count; ++k) out[first + k] = static_cast<float>(values[k]);
    }
}

}  // namespace whorl::app
