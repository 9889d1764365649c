// Several numbers worked on at once: one formula serves a single number and a vector register of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "core/base/real.h"
#include "core/parallel/isa.h"

namespace whorl {

/// An integer as wide as a Real, so that both have as many to a vector.
using Index = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;

/// `bytes` of numbers: the compiler's own vectors, with + − × ÷ and comparisons element by element.
template <int bytes>
struct VectorTypes {
    using Values __attribute__((vector_size(bytes))) = Real;
    using Indices __attribute__((vector_size(bytes))) = Index;
    static constexpr int count = bytes / static_cast<int>(sizeof(Real));
};
template <int bytes>
using RealVector = typename VectorTypes<bytes>::Values;
template <int bytes>
using IndexVector = typename VectorTypes<bytes>::Indices;

/// The index type that goes with a number or a vector of them.
template <class T>
using IndexOf = std::conditional_t<std::is_same_v<T, Real>, int, IndexVector<sizeof(T)>>;

template <class T>
inline constexpr int vector_width = static_cast<int>(sizeof(T) / sizeof(Real));

/// `a` where the condition holds, else `b`.
WHORL_INLINE Real select(bool condition, Real a, Real b) {
    return condition ? a : b;
}
template <class Mask, class T>
WHORL_INLINE T select(Mask condition, T a, T b) {
    return condition ? a : b;
}

/// As std::min and std::max take them: the first where the two are equal or not ordered.
template <class T>
WHORL_INLINE T smaller(T a, T b) {
    return select(b < a, b, a);
}
template <class T>
WHORL_INLINE T larger(T a, T b) {
    return select(a < b, b, a);
}
/// The same number in every element.
template <class T>
WHORL_INLINE T broadcast(Real value) {
    return T{} + value;
}

template <class T>
WHORL_INLINE T load(const void* from) {
    T lanes;
    std::memcpy(&lanes, from, sizeof(T));
    return lanes;
}
template <class T>
WHORL_INLINE void store(T lanes, void* to) {
    std::memcpy(to, &lanes, sizeof(T));
}

/// 0, 1, 2, …
template <class I>
WHORL_INLINE I count_up() {
    I lanes;
    for (std::size_t k = 0; k < sizeof(I) / sizeof(Index); ++k) lanes[k] = static_cast<Index>(k);
    return lanes;
}

/// Whether every element is 0.
template <class I>
WHORL_INLINE bool all_zero(I lanes) {
#ifdef WHORL_HAS_ISAS
    if constexpr (sizeof(I) == 64) {
        using Words __attribute__((vector_size(64))) = long long;
        const auto words = (Words)lanes;
        return __builtin_ia32_ptestmq512(words, words, static_cast<unsigned char>(-1)) == 0;
    } else if constexpr (sizeof(I) == 32) {
        using Words __attribute__((vector_size(32))) = long long;
        const auto words = (Words)lanes;
        return __builtin_ia32_ptestz256(words, words) != 0;
    }
#endif
    Index any = 0;
    for (std::size_t k = 0; k < sizeof(I) / sizeof(Index); ++k) any |= lanes[k];
    return any == 0;
}

WHORL_INLINE Real square_root(Real x) {
    return std::sqrt(x);
}
template <class T>
WHORL_INLINE T square_root(T x) {
#ifdef WHORL_HAS_ISAS
    if constexpr (sizeof(Real) == 4 && sizeof(T) == 64) {
        return __builtin_ia32_sqrtps512_mask(x, x, static_cast<unsigned short>(-1), 4);
    } else if constexpr (sizeof(Real) == 4 && sizeof(T) == 32) {
        return __builtin_ia32_sqrtps256(x);
    } else if constexpr (sizeof(Real) == 4 && sizeof(T) == 16) {
        return __builtin_ia32_sqrtps(x);
    }
#endif
    for (int k = 0; k < vector_width<T>; ++k) x[k] = std::sqrt(x[k]);
    return x;
}

/// The largest whole number not above x, |x| below 2²².
template <class T>
WHORL_INLINE T round_down(T x) {
#ifdef WHORL_HAS_ISAS
    constexpr int down = 9;  // towards −∞, without the inexact flag
    if constexpr (sizeof(Real) == 4 && sizeof(T) == 64) {
        return __builtin_ia32_rndscaleps_mask(x, down, x, static_cast<unsigned short>(-1), 4);
    } else if constexpr (sizeof(Real) == 4 && sizeof(T) == 32) {
        return __builtin_ia32_roundps256(x, down);
    }
#endif
    const T cut = __builtin_convertvector(__builtin_convertvector(x, IndexVector<sizeof(T)>), T);
    return cut - select(x < cut, broadcast<T>(1), T{});
}

template <class T>
WHORL_INLINE IndexVector<sizeof(T)> to_indices(T whole) {
    return __builtin_convertvector(whole, IndexVector<sizeof(T)>);
}
template <class T, class I>
WHORL_INLINE T to_values(I indices) {
    return __builtin_convertvector(indices, T);
}

}  // namespace whorl
