// The limiter that falls back on the first-order value.
#include "core/limiters/make_limiter.h"

namespace whorl {
namespace {

struct Revert {
    static constexpr SchemeInfo info{"revert", "Revert", "Selle et al. 2008",
                                     "Where a new extremum would appear, the first-order result is taken."};
    static constexpr LimiterTraits traits{.falls_back = true};
    template <class T>
    static WHORL_INLINE T limit(T value, T first_order, T low, T high) {
        return select(value < low, first_order, select(value > high, first_order, value));
    }
};

}  // namespace

extern constinit const Limiter revert_limiter = make_limiter<Revert>();

}  // namespace whorl
