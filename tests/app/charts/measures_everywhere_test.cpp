// Every measure of the list is in every place that shows measures, and so is one that is added.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "app/charts/charts.h"
#include "app/charts/measure_tabs.h"
#include "app/charts/plots_csv.h"
#include "app/cli/verbs.h"
#include "app/lessons/lesson_run.h"
#include "app/scenes/presets.h"
#include "tests/support/headless_ui.h"
#include "tests/support/lanes_window.h"
#include "tests/support/own_directory.h"

namespace whorl::app {
namespace {

const Measure smoke_height{.key = "smoke_height",
                           .title = "Height of the smoke",
                           .unit = "length",
                           .help = "Mean height of the smoke, ∫ρy / ∫ρ",
                           .row =
                               [](const RowView& row, Sums& sums) {
                                   for (const int i : row.fluid()) {
                                       sums[0] += static_cast<double>(row.density[i]);
                                       sums[1] += static_cast<double>(row.density[i]) * row.y;
                                   }
                               },
                           .value = [](const Measures&, const Sums& sums) { return sums[1] / sums[0]; }};

class MeasuresEverywhere : public test::OwnDirectory {
  protected:
    void SetUp() override {
        OwnDirectory::SetUp();
        measures().add(smoke_height);
    }
    void TearDown() override {
        measures().remove(smoke_height);
        OwnDirectory::TearDown();
    }
    std::string text(const std::string& name) const { return contents(directory_ / name); }
    std::string path(const std::string& name) const { return (directory_ / name).string(); }
};

/// The words of a line of CSV.
std::vector<std::string> words(const std::string& line) {
    std::vector<std::string> all;
    std::istringstream stream(line);
    for (std::string word; std::getline(stream, word, ',');) all.push_back(word);
    return all;
}

std::vector<std::string> head_of(const std::string& csv) {
    return words(csv.substr(0, csv.find('\n')));
}

bool has(const std::vector<std::string>& all, const std::string& word) {
    return std::find(all.begin(), all.end(), word) != all.end();
}

std::string all_keys() {
    std::string keys;
    for (const Measure* measure : measures().all()) keys += (keys.empty() ? "" : ",") + measure->key;
    return keys;
}

TEST_F(MeasuresEverywhere, InTheTablesOfTheCommandLine) {
    RunArguments run;
    run.scene = "plume";
    run.set = {"resolution=16"};
    run.steps = 3;
    run.csv = path("run.csv");
    run.threads = 1;
    ASSERT_EQ(run_scene(run), 0);
    EXPECT_TRUE(has(head_of(text("run.csv")), "smoke_height")) << "of itself";
    run.measures = all_keys();
    ASSERT_EQ(run_scene(run), 0);
    const std::vector<std::string> head = head_of(text("run.csv"));
    EXPECT_EQ(head.size(), 2 + measures().all().size());
    for (const Measure* measure : measures().all()) EXPECT_TRUE(has(head, measure->key)) << measure->key;
    const std::string rows = text("run.csv");
    const std::string last = rows.substr(rows.rfind('\n', rows.size() - 2) + 1);
    EXPECT_GT(std::stod(words(last).back()), 0) << "the added measure's value: " << last;

    ExperimentArguments experiment;
    experiment.scene = "rest";
    experiment.set = {"resolution=16"};
    experiment.at = {1};
    experiment.csv = path("experiment.csv");
    experiment.threads = 1;
    ASSERT_EQ(run_experiment(experiment), 0);
    EXPECT_TRUE(has(head_of(text("experiment.csv")), "smoke_height"));

    CompareArguments compare;
    compare.scene = "plume";
    compare.set = {"resolution=16"};
    compare.at = {1, 2};
    compare.csv = path("compare.csv");
    compare.threads = 1;
    ASSERT_EQ(run_compare(compare), 0);
    EXPECT_TRUE(has(head_of(text("compare.csv")), "smoke_height"));

    testing::internal::CaptureStdout();
    run_list({"measures"});
    const std::string listed = testing::internal::GetCapturedStdout();
    for (const Measure* measure : measures().all())
        EXPECT_NE(listed.find("  " + measure->key + " "), std::string::npos) << measure->key;
}

Recording small_plume(std::size_t lanes) {
    Recording run{.setup = {.scene = presets().front().scene()}};
    run.setup.scene.resolution = 16;
    run.setup.lanes = std::vector<LaneSetup>(lanes);
    return run;
}

/// Writes the keys of the controls that a tab draws.
void draw_keys(HeadlessUi& ui, const std::string& path, MeasureTab tab, std::size_t lanes) {
    LanesWindow window(ui, small_plume(lanes), path);
    window.measure_view.tab = tab;
    for (int frame = 0; frame < 3; ++frame) window.frame();
}

TEST_F(MeasuresEverywhere, InPlotsAndTableOfTheWindow) {
    HeadlessUi ui(1600, 1400, 1);
    for (const std::size_t lanes : {1u, 2u}) {
        draw_keys(ui, path("keys"), MeasureTab::Plots, lanes);
        const std::string plots = text("keys");
        EXPECT_NE(plots.find("\"plot=Height of the smoke\""), std::string::npos) << lanes;
        draw_keys(ui, path("keys"), MeasureTab::Table, lanes);
        const std::string table = text("keys");
        EXPECT_NE(table.find("\"Other=Height of the smoke\""), std::string::npos) << lanes;
        for (const Measure* measure : measures().all()) {
            const std::string& group = measure->column.group;
            if (group.empty() || measure->needs == Needs::Reference) continue;
            EXPECT_NE(table.find("\"" + group + "=" + measure->head() + "\""), std::string::npos)
                << measure->key;
        }
    }
}

/// Steps work it out while its tab is in sight, and its curve has the values.
TEST_F(MeasuresEverywhere, InHistoryAndItsTableAndInPictures) {
    HeadlessUi ui(1600, 1400, 1);
    LanesWindow window(ui, small_plume(2));
    ASSERT_TRUE(
        window.eventually([&] { return !window.player.newest().lanes.front().measures.reduced.empty(); }));
    window.client.play(true);
    const auto while_it_runs = [&](auto&& is_so) {
        return window.eventually([&] {
            window.player.begin_frame();
            return is_so();
        });
    };
    ASSERT_TRUE(while_it_runs([&] { return window.client.session().step > 5; }));
    const SessionSnapshot& moment = window.client.session();
    const LaneHistory& lane = window.history.lane(moment.ids[1]);
    for (const Measure* measure : measures().all())
        EXPECT_EQ(lane.of(*measure).size(), lane.steps.size()) << measure->key;
    EXPECT_GT(lane.of(smoke_height)[3], 0);
    const std::string csv = plots_csv({{"lane", lane}});
    for (const Measure* measure : measures().all())
        EXPECT_TRUE(has(head_of(csv), measure->key)) << measure->key;
    const std::vector<SheetPlot> plots = plots_of(window.history, moment, window.measure_view);
    EXPECT_TRUE(std::any_of(plots.begin(), plots.end(),
                            [](const SheetPlot& plot) { return plot.title == "Height of the smoke"; }));
    // Where no tab shows it, steps are spared the work.
    window.measure_view.tab = MeasureTab::Spectrum;
    EXPECT_TRUE(while_it_runs([&] { return window.player.newest().lanes.front().measures.reduced.empty(); }));
}

TEST_F(MeasuresEverywhere, InChartsOfTheirPage) {
    const Measure& norm = measures().find("L2");
    for (const Page page : {Page::Plots, Page::Budget, Page::BudgetShares}) {
        std::set<const Measure*> shown;
        std::set<std::string> keys;
        for (const Chart& chart : charts_of(page)) {
            EXPECT_TRUE(keys.insert(chart.key).second) << chart.key;
            for (const Measure* measure : chart.curves) {
                EXPECT_TRUE(shown.insert(measure).second) << measure->key;
                EXPECT_EQ(measure->plot.unit, chart.first().plot.unit) << measure->key;
                if (measure->plot.unit) {
                    EXPECT_EQ(measure->unit, chart.first().unit) << measure->key << ": one axis, one unit";
                }
                EXPECT_EQ(measure->timing, chart.first().timing) << measure->key;
            }
        }
        for (const Measure* measure : measures().all())
            EXPECT_EQ(shown.contains(measure), measure->plot.page == page) << measure->key;
        for (const Chart& chart : lanes_charts_of(page, norm))
            EXPECT_EQ(chart.curves.size(), 1u) << chart.key;
    }
}

TEST_F(MeasuresEverywhere, InClaimsOfLessons) {
    for (const Measure* measure : measures().all()) {
        if (measure->timing) {
            EXPECT_THROW(claimed_measure(measure->key), InputError) << measure->key;
        } else {
            EXPECT_EQ(&claimed_measure(measure->key), measure);
        }
    }
    const Lesson lesson = parse_lesson(R"(whorl = 1
title = "T"
summary = "S"
[[step]]
title = "one"
text = "a"
scene = "plume"
set = ["resolution=16"]
run_to = 4
[[step.claim]]
measure = "smoke_height"
at_least = 0.1
)",
                                       "small");
    Pool pool(1);
    LessonRun run(pool);
    run.enter(lesson.steps[0]);
    EXPECT_GT(run.measure(lesson.steps[0].claims[0]), 0.1);
}

}  // namespace
}  // namespace whorl::app
