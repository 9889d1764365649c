// Reading scattered samples into vectors, by as few loads as their order in memory allows.
#pragma once

#include <utility>

#include "core/parallel/simd.h"

namespace whorl {

namespace detail {

template <int bytes>
struct Chunk {
    using Type __attribute__((vector_size(bytes))) = Real;
};

template <class T, std::size_t... K>
WHORL_INLINE T each_from(const Real* from, const Index* at, std::index_sequence<K...>) {
    return T{from[at[K]]...};
}

template <class T, std::size_t... K>
WHORL_INLINE T every_second(T a, T b, std::index_sequence<K...>, std::integral_constant<int, 0>) {
    return __builtin_shufflevector(a, b, (static_cast<int>(2 * K))...);
}
template <class T, std::size_t... K>
WHORL_INLINE T every_second(T a, T b, std::index_sequence<K...>, std::integral_constant<int, 1>) {
    return __builtin_shufflevector(a, b, (static_cast<int>(2 * K + 1))...);
}

template <class T, std::size_t... K>
WHORL_INLINE auto join(T a, T b, std::index_sequence<K...>) {
    return __builtin_shufflevector(a, b, (static_cast<int>(K))...);
}
/// Two neighbours from each of `width / 2` indices, side by side; they travel as one double.
template <int width>
WHORL_INLINE auto pairs_from(const Real* from, const Index* at) {
    if constexpr (width == 4) {
        using Pairs __attribute__((vector_size(16))) = double;
        return (typename Chunk<16>::Type)Pairs{load<double>(from + at[0]), load<double>(from + at[1])};
    } else {
        return join(pairs_from<width / 2>(from, at), pairs_from<width / 2>(from, at + width / 4),
                    std::make_index_sequence<width>{});
    }
}
/// Four neighbours from each of `width / 4` indices, side by side.
template <int width>
WHORL_INLINE auto quads_from(const Real* from, const Index* at) {
    if constexpr (width == 4) {
        return load<typename Chunk<16>::Type>(from + at[0]);
    } else {
        return join(quads_from<width / 2>(from, at), quads_from<width / 2>(from, at + width / 8),
                    std::make_index_sequence<width>{});
    }
}
/// Of every four elements, two of each operand: a, b, a, b (`low`: the first two of each four, else the
/// last).
template <bool low, class T, std::size_t... K>
WHORL_INLINE T zip(T a, T b, std::index_sequence<K...>) {
    constexpr auto lane = [](std::size_t k) {
        const std::size_t in_four = (low ? 0 : 2) + k % 4 / 2;
        return static_cast<int>(k / 4 * 4 + in_four + (k % 2 == 0 ? 0 : sizeof...(K)));
    };
    return __builtin_shufflevector(a, b, (lane(K))...);
}
/// Of every four elements, the same half of each operand: a, a, b, b.
template <bool low, class T, std::size_t... K>
WHORL_INLINE T halves(T a, T b, std::index_sequence<K...>) {
    constexpr auto lane = [](std::size_t k) {
        const std::size_t in_four = (low ? 0 : 2) + k % 2;
        return static_cast<int>(k / 4 * 4 + in_four + (k % 4 < 2 ? 0 : sizeof...(K)));
    };
    return __builtin_shufflevector(a, b, (lane(K))...);
}

}  // namespace detail

/// A vector that reads neighbours: element k at index first + k.
template <class T>
class Contiguous {
  public:
    WHORL_INLINE explicit Contiguous(IndexVector<sizeof(T)> at) : first_(at[0]) {}

    /// The samples at each index, and those after them.
    WHORL_INLINE void pair(const Real* from, T& q0, T& q1) const {
        q0 = load<T>(from + first_);
        q1 = load<T>(from + first_ + 1);
    }
    /// The sample before each index, the one there, and the two after it.
    WHORL_INLINE void four(const Real* from, T& qm, T& q0, T& q1, T& q2) const {
        pair(from - 1, qm, q0);
        pair(from + 1, q1, q2);
    }

  private:
    Index first_;
};

/// A vector that reads from anywhere: element k at index `at[k]`.
template <class T>
class Gathered {
  public:
    static constexpr int width = vector_width<T>;

    WHORL_INLINE explicit Gathered(IndexVector<sizeof(T)> at) { store(at, at_); }

    WHORL_INLINE void pair(const Real* from, T& q0, T& q1) const {
        if constexpr (sizeof(Real) == 4) {
            const auto all = std::make_index_sequence<width>{};
            const T a = detail::pairs_from<width>(from, at_);
            const T b = detail::pairs_from<width>(from, at_ + width / 2);
            q0 = detail::every_second(a, b, all, std::integral_constant<int, 0>{});
            q1 = detail::every_second(a, b, all, std::integral_constant<int, 1>{});
        } else {
            q0 = detail::each_from<T>(from, at_, std::make_index_sequence<width>{});
            q1 = detail::each_from<T>(from + 1, at_, std::make_index_sequence<width>{});
        }
    }
    WHORL_INLINE void four(const Real* from, T& qm, T& q0, T& q1, T& q2) const {
        if constexpr (sizeof(Real) == 4) {
            const auto all = std::make_index_sequence<width>{};
            Index turned[width];  // elements m, m + 4, m + 8, … together
            for (int k = 0; k < width; ++k) turned[k % 4 * (width / 4) + k / 4] = at_[k];
            const T a = quads(from - 1, turned, 0), b = quads(from - 1, turned, 1);
            const T c = quads(from - 1, turned, 2), d = quads(from - 1, turned, 3);
            const T ab_low = detail::zip<true>(a, b, all), ab_high = detail::zip<false>(a, b, all);
            const T cd_low = detail::zip<true>(c, d, all), cd_high = detail::zip<false>(c, d, all);
            qm = detail::halves<true>(ab_low, cd_low, all);
            q0 = detail::halves<false>(ab_low, cd_low, all);
            q1 = detail::halves<true>(ab_high, cd_high, all);
            q2 = detail::halves<false>(ab_high, cd_high, all);
        } else {
            pair(from - 1, qm, q0);
            pair(from + 1, q1, q2);
        }
    }

  private:
    static WHORL_INLINE T quads(const Real* from, const Index* turned, int m) {
        return detail::quads_from<width>(from, turned + m * (width / 4));
    }

    Index at_[width];
};

/// Whether indices are neighbours. Smooth flows keep them together, and then a load serves a whole vector.
template <class I>
WHORL_INLINE bool is_contiguous(I at) {
    return all_zero(at - at[0] - count_up<I>());
}

}  // namespace whorl
