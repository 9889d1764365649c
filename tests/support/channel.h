// Domains that wrap along one axis and have walls across the other.
#pragma once

#include "core/grid/sides.h"

namespace whorl::test {

inline constexpr Sides channel_x{
    .left = {&periodic_side}, .right = {&periodic_side}, .bottom = {}, .top = {}};
inline constexpr Sides channel_y{
    .left = {}, .right = {}, .bottom = {&periodic_side}, .top = {&periodic_side}};
inline constexpr Sides all_sides[] = {sides::box, sides::periodic, channel_x, channel_y};

/// "box", "periodic", "channel along x" or "channel along y".
inline const char* name(const Sides& sides) {
    constexpr const char* names[] = {"box", "channel along y", "channel along x", "periodic"};
    return names[2 * sides.wraps().x + sides.wraps().y];
}

}  // namespace whorl::test
