#include "core/sources/emitters.h"

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
        for (std::size_t k = 0; k < state.scalars.size(); ++k) {
            const FieldInfo& info = scalar(k).info();
            if (!info.source) continue;
            Field& field = state.scalars[k];
            const double amount = emitter.amounts[scalar(k)];
            double change = 0;
            for (int j = j0; j < j1; ++j) {
                for (int i = i0; i < i1; ++i) {
                    if (state.boundary.solid(i, j)) continue;
                    change += amount - static_cast<double>(field(i, j));
                    field(i, j) = static_cast<Real>(amount);
                }
            }
            if (info.counted) state.injected[k] += change * grid.cell();
        }
    }
    if (!changed) return;
    for (Field& field : state.scalars) state.boundary.fill(field);
}

}  // namespace whorl
