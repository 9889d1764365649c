// Reading scattered samples into lanes, by as few loads as their order in memory allows.
#pragma once

#include <utility>

#include "core/parallel/lanes.h"

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

/// Two neighbours travel as one double.
template <std::size_t... K>
WHORL_INLINE auto pairs_from(const Real* from, const Index* at, std::index_sequence<K...>) {
    using Pairs __attribute__((vector_size(8 * sizeof...(K)))) = double;
    return Pairs{load<double>(from + at[K])...};
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
/// Four neighbours from each of `lanes / 4` places, every fourth of those at `at`, side by side.
template <int lanes>
WHORL_INLINE auto quads_from(const Real* from, const Index* at) {
    if constexpr (lanes == 4) {
        return load<typename Chunk<16>::Type>(from + at[0]);
    } else {
        return join(quads_from<lanes / 2>(from, at), quads_from<lanes / 2>(from, at + lanes / 8),
                    std::make_index_sequence<lanes>{});
    }
}
/// Of every four lanes, two of each operand: a, b, a, b (`low`: the first two of each four, else the last).
template <bool low, class T, std::size_t... K>
WHORL_INLINE T zip(T a, T b, std::index_sequence<K...>) {
    constexpr auto lane = [](std::size_t k) {
        const std::size_t in_four = (low ? 0 : 2) + k % 4 / 2;
        return static_cast<int>(k / 4 * 4 + in_four + (k % 2 == 0 ? 0 : sizeof...(K)));
    };
    return __builtin_shufflevector(a, b, (lane(K))...);
}
/// Of every four lanes, the same half of each operand: a, a, b, b.
template <bool low, class T, std::size_t... K>
WHORL_INLINE T halves(T a, T b, std::index_sequence<K...>) {
    constexpr auto lane = [](std::size_t k) {
        const std::size_t in_four = (low ? 0 : 2) + k % 2;
        return static_cast<int>(k / 4 * 4 + in_four + (k % 4 < 2 ? 0 : sizeof...(K)));
    };
    return __builtin_shufflevector(a, b, (lane(K))...);
}

}  // namespace detail

/// Where lanes read from one array: lane k at index `at[k]`. Smooth flows keep neighbours together, and what
/// lies in a row is one load.
template <class T>
class Reader {
  public:
    using Indices = IndexLanes<sizeof(T)>;
    static constexpr int lanes = lane_count<T>;

    WHORL_INLINE Reader(const Real* origin, Indices at) : origin_(origin), first_(at[0]) {
        in_a_row_ = all_zero(at - first_ - count_up<Indices>());
        store(at, at_);
    }

    /// The samples `offset` from each lane's place, and those after them.
    WHORL_INLINE void pair(Index offset, T& q0, T& q1) const {
        const Real* from = origin_ + offset;
        if (in_a_row_) {
            q0 = load<T>(from + first_);
            q1 = load<T>(from + first_ + 1);
        } else if constexpr (sizeof(Real) == 4) {
            const auto half = std::make_index_sequence<lanes / 2>{};
            const auto all = std::make_index_sequence<lanes>{};
            const T a = (T)detail::pairs_from(from, at_, half);
            const T b = (T)detail::pairs_from(from, at_ + lanes / 2, half);
            q0 = detail::every_second(a, b, all, std::integral_constant<int, 0>{});
            q1 = detail::every_second(a, b, all, std::integral_constant<int, 1>{});
        } else {
            q0 = detail::each_from<T>(from, at_, std::make_index_sequence<lanes>{});
            q1 = detail::each_from<T>(from + 1, at_, std::make_index_sequence<lanes>{});
        }
    }

    /// The samples `offset` − 1 … `offset` + 2 from each lane's place.
    WHORL_INLINE void four(Index offset, T& qm, T& q0, T& q1, T& q2) const {
        const Real* from = origin_ + offset - 1;
        if (in_a_row_) {
            qm = load<T>(from + first_);
            q0 = load<T>(from + first_ + 1);
            q1 = load<T>(from + first_ + 2);
            q2 = load<T>(from + first_ + 3);
        } else if constexpr (sizeof(Real) == 4) {
            const auto all = std::make_index_sequence<lanes>{};
            Index turned[lanes];  // lanes m, m + 4, m + 8, … together
            for (int k = 0; k < lanes; ++k) turned[k % 4 * (lanes / 4) + k / 4] = at_[k];
            const T a = quads(from, turned, 0), b = quads(from, turned, 1);
            const T c = quads(from, turned, 2), d = quads(from, turned, 3);
            const T ab_low = detail::zip<true>(a, b, all), ab_high = detail::zip<false>(a, b, all);
            const T cd_low = detail::zip<true>(c, d, all), cd_high = detail::zip<false>(c, d, all);
            qm = detail::halves<true>(ab_low, cd_low, all);
            q0 = detail::halves<false>(ab_low, cd_low, all);
            q1 = detail::halves<true>(ab_high, cd_high, all);
            q2 = detail::halves<false>(ab_high, cd_high, all);
        } else {
            pair(offset - 1, qm, q0);
            pair(offset + 1, q1, q2);
        }
    }

  private:
    static WHORL_INLINE T quads(const Real* from, const Index* turned, int m) {
        return detail::quads_from<lanes>(from, turned + m * (lanes / 4));
    }

    const Real* origin_;
    Index first_;
    bool in_a_row_;
    Index at_[lanes];
};

}  // namespace whorl
