// The sides of the domain, each by its rules.
#pragma once

#include "core/base/registry.h"
#include "core/base/scheme_info.h"

namespace whorl {

/// Along which axes the domain closes on itself.
struct Wraps {
    bool x = false, y = false;
    constexpr bool operator==(const Wraps&) const = default;
};

/// What is 0 at a side: a quantity itself, or its gradient across.
enum class Condition { Zero, ZeroGradient };

/// A kind of side, by its rules.
struct SideKind {
    std::string_view key;
    bool wraps = false;  ///< it is the same place as the opposite side; the conditions then say nothing
    Condition normal{};  ///< of the velocity across it
    Condition tangential{};
    Condition scalars{};
    Condition pressure{};
};

/// A free-slip wall.
inline constexpr SideKind wall_side{.key = "wall",
                                    .normal = Condition::Zero,
                                    .tangential = Condition::ZeroGradient,
                                    .scalars = Condition::ZeroGradient,
                                    .pressure = Condition::ZeroGradient};
/// What leaves comes in on the opposite side.
inline constexpr SideKind periodic_side{.key = "periodic", .wraps = true};

/// One side. What a kind has to be told (a speed, amounts) goes beside it.
struct Side {
    const SideKind* kind = &wall_side;
    constexpr bool operator==(const Side&) const = default;
};

struct Sides {
    Side left, right, bottom, top;
    constexpr Wraps wraps() const { return {left.kind->wraps, bottom.kind->wraps}; }
    constexpr bool operator==(const Sides&) const = default;
};

/// Four sides by one word: what files, command lines and menus offer.
struct NamedSides {
    SchemeInfo info;
    Sides sides;

    /// All of them; the first is the default.
    static Registry<NamedSides>& list();
};

namespace sides {
inline constexpr Sides box{};
inline constexpr Sides periodic{{&periodic_side}, {&periodic_side}, {&periodic_side}, {&periodic_side}};
}  // namespace sides

/// @throws InputError if they have no name
const NamedSides& named(const Sides& sides);

}  // namespace whorl
