// Archives agree with each other about one memory.
#include "core/base/archive.h"

#include <gtest/gtest.h>

#include "core/base/real.h"

namespace whorl {
namespace {

struct Memory {
    int age = 3;
    double time = 0.25;
    std::vector<Vec2> positions{{1, 2}, {3, 4}};
    std::vector<std::int16_t> counts{-1, 2};

    void archive(Archive& a) {
        a("age", age);
        a("time", time);
        a("positions", positions);
        a("counts", counts);
    }
    std::vector<std::byte> saved() {
        SavingArchive a;
        archive(a);
        return a.saved;
    }
    std::uint64_t digest() {
        DigestingArchive a;
        archive(a);
        return a.value();
    }
};

TEST(Archive, RestoresWhatItSaved) {
    Memory one;
    one.positions.emplace_back(5, 6);
    one.age = -7;
    const std::vector<std::byte> saved = one.saved();
    Memory other;
    EXPECT_NE(other.digest(), one.digest());
    RestoringArchive a(saved);
    other.archive(a);
    EXPECT_EQ(other.age, -7);
    EXPECT_EQ(other.positions.size(), 3u);
    EXPECT_EQ(other.counts, one.counts);
    EXPECT_EQ(other.digest(), one.digest());
}

TEST(Archive, DigestsEveryNumber) {
    const std::uint64_t before = Memory{}.digest();
    Memory count, position, age, longer;
    count.counts[0] = -300;
    position.positions[1].x = Real(2.5);
    age.age = -2;
    longer.positions.emplace_back(0, 0);
    for (Memory* changed : {&count, &position, &age, &longer}) EXPECT_NE(changed->digest(), before);
}

TEST(Archive, RefusesWhatWasNotSaved) {
    Memory memory;
    const std::vector<std::byte> saved = memory.saved();
    const std::vector<std::byte> cut(saved.begin(), saved.end() - 1);
    RestoringArchive a(cut);
    EXPECT_THROW(memory.archive(a), std::logic_error);
}

}  // namespace
}  // namespace whorl
