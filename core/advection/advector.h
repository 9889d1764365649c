// What an advector is: an entry of a list, apart from its body.
#pragma once

#include <memory>

#include "core/base/id.h"
#include "core/base/scheme_info.h"

namespace whorl {

class Transport;

/// How much of the Taylor expansion around its departure point a particle carries to its node; `None` is a
/// scheme without particles.
enum class Expansion { None, Value, Gradient, CrossTerm };

/// What an advector says of itself.
struct AdvectorTraits {
    bool base_step = false;                 ///< is made of steps of a base scheme: a predictor-corrector
    Expansion expansion = Expansion::None;  ///< of its own particles
    bool limited = false;                   ///< heeds the limiter
    bool memory = false;                    ///< remembers more than the fields from step to step
    std::string_view clamp_source{};        ///< where its clamp is described, if not where the limiter is
};

struct Advector {
    SchemeInfo info;
    AdvectorTraits traits;
    std::unique_ptr<Transport> (*make)();

    /// All advectors; the first is the default.
    static Registry<Advector>& list();
};

/// What a predictor-corrector takes as its step A: an advector's whole step, unlimited or clamped.
struct BaseScheme {
    SchemeInfo info;
    const Advector* step;
    bool clamped;

    /// All base schemes; the first is the default.
    static Registry<BaseScheme>& list();
};

}  // namespace whorl
