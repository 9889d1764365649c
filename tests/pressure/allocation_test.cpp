// A solve allocates nothing after the first, and neither does a projection.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/pressure/projection.h"
#include "tests/pressure/domains.h"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size) {
    ++allocations;
    if (void* at = std::malloc(size ? size : 1)) return at;
    throw std::bad_alloc();
}

void* counted(std::size_t size, std::align_val_t alignment) {
    ++allocations;
    const auto step = static_cast<std::size_t>(alignment);
    if (void* at = std::aligned_alloc(step, (size + step - 1) / step * step)) return at;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return counted(size, alignment);
}
void operator delete(void* at) noexcept {
    std::free(at);
}
void operator delete[](void* at) noexcept {
    std::free(at);
}
void operator delete(void* at, std::size_t) noexcept {
    std::free(at);
}
void operator delete[](void* at, std::size_t) noexcept {
    std::free(at);
}
void operator delete(void* at, std::align_val_t) noexcept {
    std::free(at);
}
void operator delete[](void* at, std::align_val_t) noexcept {
    std::free(at);
}
void operator delete(void* at, std::size_t, std::align_val_t) noexcept {
    std::free(at);
}
void operator delete[](void* at, std::size_t, std::align_val_t) noexcept {
    std::free(at);
}

namespace whorl::test {
namespace {

TEST(Allocation, NoneInASolveAfterTheFirst) {
    Pool pool(2);
    for (const bool obstacles : {false, true}) {
        const Boundary boundary =
            domain(96, 80, false, obstacles ? discs(96, 80) : std::vector<std::uint8_t>{});
        for (const PressureSolverEntry& each : pressure_solvers()) {
            if (!each.refuses(boundary).empty()) continue;
            const std::vector<double> b = random_right(boundary, 3, pool);
            std::vector<double> p(b.size(), 0);
            const auto solver = each.create();
            solver->prepare(boundary, pool);
            solver->solve(b, 1e-6, p, pool);
            std::fill(p.begin(), p.end(), 0.0);
            const long before = allocations;
            solver->solve(b, 1e-6, p, pool);
            EXPECT_EQ(allocations, before) << each.info.key;
        }
    }
}

TEST(Allocation, NoneInAProjectionAfterTheFirst) {
    Pool pool(2);
    for (const PressureSolverEntry& each : pressure_solvers()) {
        const Boundary boundary = domain(64, 64, true, discs(64, 64));
        FaceVelocity velocity = boundary.velocity();
        Field pressure = boundary.field(Site::Centre);
        Projection projection;
        projection.set_solver(index_of(each.info.key), 1e-5);
        velocity.v(20, 20) = 1;
        projection.project(velocity, 0.1, boundary, pressure, pool);
        velocity.v(40, 20) = 1;
        const long before = allocations;
        projection.project(velocity, 0.1, boundary, pressure, pool);
        EXPECT_EQ(allocations, before) << each.info.key;
    }
}

}  // namespace
}  // namespace whorl::test
