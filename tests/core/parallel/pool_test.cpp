// The pool: every row is worked on once, by threads that exist, however many rows and threads there are.
#include "core/parallel/pool.h"

#include <gtest/gtest.h>

#include <vector>

namespace whorl {
namespace {

TEST(Pool, WorksOnEveryRowOnce) {
    for (const int threads : {1, 2, 3, 8}) {
        Pool pool(threads);
        EXPECT_EQ(pool.threads(), threads);
        for (const int rows : {0, 1, 2, 7, 64, 1001}) {
            std::vector<int> visits(static_cast<std::size_t>(rows));
            pool.bands(rows, [&](int first, int last) {
                for (int j = first; j < last; ++j) ++visits[static_cast<std::size_t>(j)];
            });
            EXPECT_EQ(visits, std::vector<int>(visits.size(), 1))
                << threads << " threads, " << rows << " rows";
        }
    }
}

TEST(Pool, GivesEachThreadAPlaceOfItsOwn) {
    Pool pool(3);
    std::vector<long> sums(3);
    constexpr int rows = 1000, times = 200;
    for (int k = 0; k < times; ++k) {
        pool.bands(rows, [&](int first, int last, int thread) {
            for (int j = first; j < last; ++j) sums[static_cast<std::size_t>(thread)] += j;
        });
    }
    EXPECT_EQ(sums[0] + sums[1] + sums[2], times * (rows - 1L) * rows / 2);
}

TEST(Pool, ShowsTheNextLoopWhatTheLastOneWrote) {
    Pool pool(4);
    std::vector<int> a(513, 1), b(a.size());
    const int rows = static_cast<int>(a.size());
    for (int k = 0; k < 100; ++k) {
        // Each reads what other threads wrote in the loop before.
        pool.bands(rows, [&](int first, int last) {
            for (int j = first; j < last; ++j)
                b[static_cast<std::size_t>(j)] = a[static_cast<std::size_t>(rows - 1 - j)] + 1;
        });
        a.swap(b);
    }
    EXPECT_EQ(a, std::vector<int>(a.size(), 101));
}

}  // namespace
}  // namespace whorl
