#include "core/parallel/isa.h"

namespace whorl {

std::span<const Isa> available_isas() {
    static constexpr Isa all[] = {Isa::Baseline, Isa::Avx2, Isa::Avx512};
#ifdef WHORL_HAS_ISAS
    const bool avx2 =
        __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
    const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                        __builtin_cpu_supports("avx512vl");
    return std::span(all).first(avx512 ? 3 : avx2 ? 2 : 1);
#else
    return std::span(all).first(1);
#endif
}

Isa best_isa() {
    return available_isas().back();
}

std::string_view name(Isa isa) {
    switch (isa) {
        case Isa::Avx2:
            return "AVX2";
        case Isa::Avx512:
            return "AVX-512";
        case Isa::Baseline:
            break;
    }
    return "baseline";
}

}  // namespace whorl
