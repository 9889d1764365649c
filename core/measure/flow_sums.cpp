#include "core/measure/flow_sums.h"

#include <algorithm>
#include <functional>

#include "core/parallel/row_bands.h"
#include "core/parallel/simd.h"

namespace whorl {
namespace {

void add_cell(const FaceRows& rows, int i, Real quarter_over_h, FlowSums& sum) {
    const auto square = [](Real x) { return static_cast<double>(x) * static_cast<double>(x); };
    sum.kinetic_energy +=
        0.25 * (square(rows.u[i]) + square(rows.u[i + 1]) + square(rows.v[i]) + square(rows.v_above[i]));
    sum.enstrophy += 0.5 * square(vorticity_at<Real>(rows, i, quarter_over_h));
}

/// The same for `count` cells, eight sums side by side whatever the instruction set, so that all give the
/// same bits.
struct AddCellsLoop {
    template <int>
    WHORL_INLINE static void run(const FaceRows& rows, int count, Real quarter_over_h, FlowSums& sum) {
        constexpr int lanes = 8;
        using T = RealVector<lanes * sizeof(Real)>;
        using Wide __attribute__((vector_size(lanes * sizeof(double)))) = double;
        Wide energy{}, enstrophy{};
        int i = 0;
        for (; i + lanes <= count; i += lanes) {
            Wide squares{};
            for (const Real* face : {rows.u, rows.u + 1, rows.v, rows.v_above}) {
                const Wide velocity = __builtin_convertvector(load<T>(face + i), Wide);
                squares += velocity * velocity;
            }
            energy += squares;
            const Wide w =
                __builtin_convertvector(vorticity_at<T>(rows, i, broadcast<T>(quarter_over_h)), Wide);
            enstrophy += w * w;
        }
        for (int k = 0; k < lanes; ++k) {
            sum.kinetic_energy += 0.25 * energy[k];
            sum.enstrophy += 0.5 * enstrophy[k];
        }
        for (; i < count; ++i) add_cell(rows, i, quarter_over_h, sum);
    }
};

}  // namespace

FlowReducer::FlowReducer(Isa isa) : add_cells_(PerIsa<AddCells, AddCellsLoop>::pick(isa)) {}

FlowSums FlowReducer::measure(const FaceVelocity& velocity, const Boundary& boundary, Pool& pool) {
    const Grid& grid = boundary.grid();
    const Real quarter_over_h = static_cast<Real>(0.25 / grid.h);
    rows_.resize(static_cast<std::size_t>(grid.ny));
    row_bands(pool, grid.nx, grid.ny, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const FaceRows rows = face_rows(velocity, j);
            const std::uint8_t* solid = boundary.solids().data() + static_cast<std::ptrdiff_t>(j) * grid.nx;
            FlowSums sum;
            if (!boundary.has_solids() || std::all_of(solid, solid + grid.nx, std::logical_not{})) {
                add_cells_(rows, grid.nx, quarter_over_h, sum);
            } else {
                for (int i = 0; i < grid.nx; ++i) {
                    if (solid[i] == 0) add_cell(rows, i, quarter_over_h, sum);
                }
            }
            rows_[j] = sum;
        }
    });
    FlowSums sum;
    for (const FlowSums& row : rows_) sum += row;
    return {sum.kinetic_energy * grid.cell(), sum.enstrophy * grid.cell()};
}

}  // namespace whorl
