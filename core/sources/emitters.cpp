#include "core/sources/emitters.h"

#include <algorithm>
#include <cmath>

namespace whorl {

bool is_open(const Emitter& emitter, double time, double dt) {
    const double middle = time + dt / 2;
    return middle >= emitter.from && middle < emitter.until;
}

CellRange cells_of(const Emitter& emitter, const Grid& grid) {
    const auto first = [&](double low, int n) {
        return std::clamp(static_cast<int>(std::ceil(low / grid.h - 0.5)), 0, n);
    };
    return {first(emitter.x - emitter.width / 2, grid.nx), first(emitter.y - emitter.height / 2, grid.ny),
            first(emitter.x + emitter.width / 2, grid.nx), first(emitter.y + emitter.height / 2, grid.ny)};
}

void apply_emitters(State& state, std::span<const Emitter> emitters, double dt) {
    const Grid& grid = state.grid();
    bool changed = false;
    for (const Emitter& emitter : emitters) {
        if (!is_open(emitter, state.time, dt)) continue;
        changed = true;
        const CellRange cells = cells_of(emitter, grid);
        for (std::size_t k = 0; k < state.scalars.size(); ++k) {
            const FieldInfo& info = scalar(k).info();
            if (!info.source) continue;
            Field& field = state.scalars[k];
            const double amount = emitter.amounts[scalar(k)];
            double change = 0;
            for (int j = cells.begin_j; j < cells.end_j; ++j) {
                for (int i = cells.begin_i; i < cells.end_i; ++i) {
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
