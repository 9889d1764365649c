// Lists by key, numbers and CSV fields as text.
#include "core/base/registry.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/csv.h"
#include "core/base/number.h"

namespace whorl {
namespace {

struct Fruit {
    std::string_view key;
    std::vector<std::string_view> aliases;
};
const Fruit apple{"apple", {}}, pear{"pear", {"perry"}}, quince{"quince", {}};

TEST(Registry, FindsByKeyAndByOlderKeys) {
    const Registry<Fruit> fruits("fruit", {&apple, &pear});
    EXPECT_EQ(fruits.all().front(), &apple) << "the order is the list's";
    EXPECT_EQ(&fruits.find("pear"), &pear);
    EXPECT_EQ(&fruits.find("perry"), &pear);
    EXPECT_EQ(fruits.index(pear), 1u);
    EXPECT_EQ(fruits.seek("quince"), nullptr);
    try {
        fruits.find("paer");
        FAIL();
    } catch (const InputError& e) {
        EXPECT_STREQ(e.what(), "unknown fruit \"paer\"; did you mean pear?");
    }
}

TEST(Registry, TakesEachKeyOnce) {
    Registry<Fruit> fruits("fruit", {&apple});
    fruits.add(quince);
    EXPECT_EQ(fruits.all().back(), &quince);
    const Fruit other{"apple", {}};
    EXPECT_THROW(fruits.add(other), InputError);
    fruits.remove(quince);
    EXPECT_EQ(fruits.seek("quince"), nullptr);
}

TEST(Numbers, AreWrittenForFilesAndForReaders) {
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(significant(-0.0, 4), "0");
    EXPECT_EQ(significant(1.0 / 3, 4), "0.3333");
    EXPECT_EQ(csv_number(1.5), "1.5");
    EXPECT_EQ(csv_number(std::numeric_limits<double>::quiet_NaN()), "");
    EXPECT_EQ(csv_text("plain"), "plain");
    EXPECT_EQ(csv_text("a, \"b\""), "\"a, \"\"b\"\"\"");
}

}  // namespace
}  // namespace whorl
