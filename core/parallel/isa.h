// Instruction sets, chosen at run time: one build runs everywhere.
#pragma once

#include <span>
#include <string_view>

namespace whorl {

/// Levels of x86-64; elsewhere there is only the baseline. Results are the same bits on all of them: no level
/// contracts a product and a sum.
enum class Isa { Baseline, Avx2, Avx512 };

/// The levels that this machine has, the baseline first.
std::span<const Isa> available_isas();
/// The highest of them.
Isa best_isa();
std::string_view name(Isa isa);

// Sanitizers and clang build the baseline alone.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__) && defined(__OPTIMIZE__)
#define WHORL_HAS_ISAS 1
#define WHORL_AVX2 __attribute__((target("arch=x86-64-v3")))
#define WHORL_AVX512 __attribute__((target("arch=x86-64-v4")))
#define WHORL_INLINE __attribute__((always_inline)) inline
#else
#define WHORL_INLINE inline
#endif

/// One function compiled for every level. `Body::run<bytes>` is WHORL_INLINE and static, takes what `Fn`
/// takes, and works in vectors of `bytes` bytes.
template <class Fn, class Body>
struct PerIsa;

template <class Body, class... Args>
struct PerIsa<void (*)(Args...), Body> {
    static void baseline(Args... args) { Body::template run<16>(args...); }
#ifdef WHORL_HAS_ISAS
    WHORL_AVX2 static void avx2(Args... args) {
        Body::template run<32>(args...);
    }
    WHORL_AVX512 static void avx512(Args... args) {
        Body::template run<64>(args...);
    }

    static auto pick(Isa isa) -> void (*)(Args...) {
        return isa == Isa::Avx512 ? avx512 : isa == Isa::Avx2 ? avx2 : baseline;
    }
#else
    static auto pick(Isa) -> void (*)(Args...) {
        return baseline;
    }
#endif
};

}  // namespace whorl
