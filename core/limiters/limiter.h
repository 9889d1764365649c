// What a limiter is: an entry of a list, apart from its body.
#pragma once

#include "core/base/id.h"
#include "core/base/scheme_info.h"
#include "core/parallel/isa.h"
#include "core/sampling/node_span.h"

namespace whorl {

/// What a limiter says of itself.
struct LimiterTraits {
    bool idle = false;        ///< leaves every value as it is
    bool bounds = false;      ///< every value is then in the range of the enclosing nodes
    bool falls_back = false;  ///< may take the first-order value
};

/// Limits new values to the nodes that enclose points in `q`.  [T 3.8]
/// @param at of the points, as CellPositions::at
using LimitFn = void (*)(const Field& q, const Index* at, int count, const Values& first_order,
                         Values& value);

struct Limiter {
    SchemeInfo info;
    LimiterTraits traits;
    LimitFn (*limit)(Isa);

    /// All limiters; the first is the default.
    static Registry<Limiter>& list();
};

/// The clamp of base steps, and what takes a limiter's place where it is switched off.
extern const Limiter clamp_limiter, no_limiter;

}  // namespace whorl
