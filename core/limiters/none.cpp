// No limiter.
#include "core/limiters/make_limiter.h"

namespace whorl {
namespace {

struct None {
    static constexpr SchemeInfo info{"none", "None", "", "New extrema are left as they come."};
    static constexpr LimiterTraits traits{.idle = true};
    template <class T>
    static WHORL_INLINE T limit(T value, T, T, T) {
        return value;
    }
};

}  // namespace

extern constinit const Limiter no_limiter = make_limiter<None>();

}  // namespace whorl
