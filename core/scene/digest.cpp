#include "core/scene/digest.h"

#include <bit>
#include <type_traits>

namespace whorl {

void Digest::add(const State& state, std::uint64_t memory) {
    for_each_field(state, [this](FieldId, const Field& field) { add(field); });
    add(state.boundary.solids());
    add(state.step, state.time);
    if (memory != 0) word(memory);
}

void Digest::add(std::span<const std::uint8_t> solids) {
    for (const std::uint8_t solid : solids) word(solid);
}

void Digest::add(long step, double time) {
    word(static_cast<std::uint64_t>(step));
    word(std::bit_cast<std::uint64_t>(time));
}

void Digest::add(const Field& field) {
    using Bits = std::conditional_t<sizeof(Real) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
    for (int j = 0; j < field.height(); ++j) {
        for (int i = 0; i < field.width(); ++i) word(std::bit_cast<Bits>(field(i, j)));
    }
}

}  // namespace whorl
