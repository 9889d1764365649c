// The list of limiters, in the order of menus.
#include "core/limiters/limiter.h"

namespace whorl {

extern const Limiter revert_limiter;

Registry<Limiter>& Limiter::list() {
    static Registry<Limiter> list("limiter", {&clamp_limiter,   //
                                              &revert_limiter,  //
                                              &no_limiter});
    return list;
}

}  // namespace whorl
