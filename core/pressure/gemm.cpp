// Own loops rather than Eigen's product: its templates, compiled here for newer vector units, would be merged
// by the linker with those of other files and then run on machines that lack them.
#include "core/pressure/gemm.h"

#include <cstddef>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define WHORL_GEMM_TARGETS
#endif

namespace whorl {

// Registers hold most_rows × columns sums, the panel's row and a factor: of 16 with SSE2 and AVX2, of 32 with
// AVX-512.
namespace baseline {
constexpr int width = 2;
constexpr int columns = 2;
constexpr int most_rows = 4;
#include "core/pressure/gemm_tile.inc"
}  // namespace baseline

#ifdef WHORL_GEMM_TARGETS
#pragma GCC push_options
#pragma GCC target("arch=x86-64-v3")
namespace avx2 {
constexpr int width = 4;
constexpr int columns = 2;
constexpr int most_rows = 6;
#include "core/pressure/gemm_tile.inc"
}  // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("arch=x86-64-v4")
namespace avx512 {
constexpr int width = 8;
constexpr int columns = 2;
constexpr int most_rows = 12;
#include "core/pressure/gemm_tile.inc"
}  // namespace avx512
#pragma GCC pop_options
#endif

namespace {

using Multiply = decltype(&baseline::multiply);

Multiply fastest() {
#ifdef WHORL_GEMM_TARGETS
    __builtin_cpu_init();
    if (__builtin_cpu_supports("x86-64-v4")) return avx512::multiply;
    if (__builtin_cpu_supports("x86-64-v3")) return avx2::multiply;
#endif
    return baseline::multiply;
}

}  // namespace

void multiply(const double* left, int left_stride, const double* panel, int inner, double* out,
              int out_stride, int rows) {
    static const Multiply chosen = fastest();
    chosen(left, left_stride, panel, inner, out, out_stride, rows);
}

std::vector<double> panels_of(const std::vector<double>& matrix, int inner, int columns) {
    const int panels = padded_to_panel(columns) / panel_width;
    std::vector<double> packed(static_cast<std::size_t>(panels) * inner * panel_width, 0);
    for (int c = 0; c < columns; ++c) {
        double* panel = packed.data() + static_cast<std::size_t>(c / panel_width) * inner * panel_width;
        for (int k = 0; k < inner; ++k)
            panel[k * panel_width + c % panel_width] = matrix[static_cast<std::size_t>(k) * columns + c];
    }
    return packed;
}

}  // namespace whorl
