// The limiter that clamps.
#include "core/limiters/make_limiter.h"

namespace whorl {
namespace {

struct Clamp {
    static constexpr SchemeInfo info{"clamp", "Clamp", "thesis sec. 3.2, eq. 3.8",
                                     "New extrema are cut to the nodes that enclose the departure point."};
    static constexpr LimiterTraits traits{.bounds = true};
    template <class T>
    static WHORL_INLINE T limit(T value, T, T low, T high) {
        return smaller(larger(value, low), high);
    }
};

}  // namespace

extern constinit const Limiter clamp_limiter = make_limiter<Clamp>();

}  // namespace whorl
