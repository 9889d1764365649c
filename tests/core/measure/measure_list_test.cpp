// The list of measures: its keys, and the page of docs that shows it.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "core/measure/measure.h"

namespace whorl {
namespace {

std::string needs_text(Needs needs) {
    switch (needs) {
        case Needs::Nothing:
            break;
        case Needs::Reference:
            return "an exact solution or a reference lane";
        case Needs::LimiterMasks:
            return "counted only while asked for";
        case Needs::SolvedFlow:
            return "a flow that is solved for";
    }
    return "";
}

/// A row of the table in docs/measures.md.
std::string row(const Measure& m) {
    std::string aliases;
    for (const std::string& alias : m.aliases) aliases += ", once `" + alias + "`";
    std::string meaning = m.help + (m.source.empty() ? "" : " [" + m.source + "]");
    for (std::size_t at = 0; (at = meaning.find('|', at)) != std::string::npos; at += 2)
        meaning.insert(at, "\\");
    return "| `" + m.key + "`" + aliases + " | " + m.unit + " | " + meaning + " | " + needs_text(m.needs) +
           " |";
}

TEST(MeasureList, IsWhatTheDocsShow) {
    std::ifstream file(WHORL_TEST_DATA "/../docs/measures.md");
    std::string table, shown;
    for (const Measure* m : measures().all()) table += row(*m) + "\n";
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("| `")) shown += line + "\n";
    }
    EXPECT_TRUE(shown == table) << "docs/measures.md should have\n" << table;
}

TEST(MeasureList, SaysAllThatIsShown) {
    std::set<std::string> keys;
    for (const Measure* m : measures().all()) {
        EXPECT_TRUE(keys.insert(m->key).second) << m->key;
        for (const std::string& alias : m->aliases) EXPECT_TRUE(keys.insert(alias).second) << alias;
        EXPECT_FALSE(m->title.empty()) << m->key;
        EXPECT_FALSE(m->help.empty()) << m->key;
        EXPECT_FALSE(m->help.ends_with(".")) << m->key;
        ASSERT_TRUE(m->value) << m->key;
    }
}

/// What was written by name before there was a list.
TEST(MeasureList, ReadsOlderKeys) {
    EXPECT_EQ(measures().find("divergence_after").key, "max_divergence");
    EXPECT_EQ(measures().find("l1").key, "L1");
    EXPECT_EQ(measures().find("linf").key, "Linf");
}

TEST(MeasureList, ReadsTheRecordOfAStep) {
    Measures m;
    m.errors.L2 = 3;
    m.add("advection", {1, -2, 3});
    m.add("projection", {5, 0, 0});
    m.limited.velocity = 7;
    const auto value = [&](const char* key) { return measures().find(key).of(m); };
    EXPECT_EQ(value("L2"), 3);
    EXPECT_EQ(value("energy_by_advection"), -2);
    EXPECT_EQ(value("projection_ms"), 5);
    EXPECT_EQ(value("limited_velocity"), 7);
}

}  // namespace
}  // namespace whorl
