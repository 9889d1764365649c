// Advection allocates in its first step, and in none after it.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/advection/scheme_step.h"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    const std::size_t whole = (size + alignment - 1) / alignment * alignment;
    if (void* memory = std::aligned_alloc(alignment, whole)) return memory;
    throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) {
    return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace whorl {
namespace {

TEST(Advection, AllocatesOnlyInItsFirstStep) {
    const Stirred from({{70, 50, 1}, Sides::of<Box>(), true}, 1.5);
    Field density = from.density, temperature = from.temperature;
    FaceVelocity velocity = from.velocity;
    Group groups[3];
    groups[0].add(from.density, density);
    groups[0].add(from.temperature, temperature);
    groups[1].add(from.velocity.u, velocity.u);
    groups[2].add(from.velocity.v, velocity.v);
    Pool pool(2);
    for (std::size_t a = 0; a < Advectors::infos.size(); ++a) {
        for (std::size_t b = 0; b < Bases::infos.size(); ++b) {
            for (std::size_t s = 0; s < Stencils::infos.size(); ++s) {
                SchemeSet schemes;
                schemes.advector = Advectors::Id::at(a);
                schemes.base = Bases::Id::at(b);
                schemes.stencil = Stencils::Id::at(s);
                schemes.zeta = 1;
                Mover mover;
                const auto step = [&] {
                    mover.set(schemes, 2, 1);
                    mover.advect(groups, from.velocity, 1, from.boundary, pool);
                };
                step();
                const long before = allocations.load();
                for (int k = 0; k < 3; ++k) step();
                EXPECT_EQ(allocations.load(), before) << schemes.advector.key() << " over "
                                                      << schemes.base.key() << ", " << schemes.stencil.key();
            }
        }
    }
}

}  // namespace
}  // namespace whorl
