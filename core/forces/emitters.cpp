#include "core/forces/emitters.h"

#include <algorithm>
#include <cmath>

namespace whorl {

bool is_open(const Emitter& emitter, double time, double dt) {
    const double middle = time + dt / 2;
    return middle >= emitter.from && middle < emitter.until;
}

void apply_emitters(State& state, std::span<const Emitter> emitters, double dt) {
    const Grid& grid = state.grid();
    bool changed = false;
    for (const Emitter& emitter : emitters) {
        if (!is_open(emitter, state.time, dt)) continue;
        changed = true;
        const auto first = [&](double low, int n) {
            return std::clamp(static_cast<int>(std::ceil(low / grid.h - 0.5)), 0, n);
        };
        const int i0 = first(emitter.x - emitter.width / 2, grid.nx);
        const int i1 = first(emitter.x + emitter.width / 2, grid.nx);
        const int j0 = first(emitter.y - emitter.height / 2, grid.ny);
        const int j1 = first(emitter.y + emitter.height / 2, grid.ny);
        double change = 0;
        for (int j = j0; j < j1; ++j) {
            for (int i = i0; i < i1; ++i) {
                if (state.boundary.solid(i, j)) continue;
                change += emitter.density - static_cast<double>(state.density(i, j));
                state.density(i, j) = static_cast<Real>(emitter.density);
                state.temperature(i, j) = static_cast<Real>(emitter.temperature);
            }
        }
        state.put_in += change * grid.cell();
    }
    if (changed) {
        state.boundary.fill(state.density);
        state.boundary.fill(state.temperature);
    }
}

}  // namespace whorl
