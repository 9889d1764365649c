// A number that is measured of a run's steps: how it is called, worked out, shown and judged.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/registry.h"
#include "core/measure/measures.h"

namespace whorl {

/// What there must be for a measure to have a value.
enum class Needs {
    Nothing,
    Reference,     ///< an exact solution, or a lane that others are measured against
    LimiterMasks,  ///< that steps note where limiters act
    SolvedFlow     ///< a flow that is solved for, not given
};

/// Which of two lanes' values is the better one.
enum class Best { None, Least, NearestZero, NearestHundred };

/// What says more than the last step's value does.
enum class Mean {
    None,
    OverSteps,  ///< the mean over steps: one step's value says more of that step than of the scheme
    Median      ///< the median of the last steps: a single one is chance
};

/// The y axis of a curve.
enum class Scale {
    Fitted,
    Logarithmic,
    Percent,      ///< at least 99 to 101
    Density,      ///< at least 0 to 0.05
    Milliseconds  ///< from 0, and not flattened by a step that takes long
};

/// Where the curve of a measure is shown.
enum class Page {
    None,
    Plots,
    Budget,       ///< one curve of each lane
    BudgetShares  ///< one lane's, stacked: what each phase of a step gave or took
};

/// How a measure is plotted.
struct Plotting {
    Page page = Page::Plots;
    std::string chart{};  ///< measures of one chart share it; empty: the measure's title
    std::string label{};  ///< in a chart's legend and a table's head; empty: the measure's title
    int colour = 0;       ///< in a chart, and the place of its curve there
    Scale scale = Scale::Fitted;
    bool unit = true;  ///< whether the chart shows it
    /// The chart's title where it has one curve of each lane. Empty: the chart's, with the measure of colour
    /// 0.
    std::string lanes_chart{};
    std::string shared{};  ///< of BudgetShares: what the phases share
};

/// The column of a measure in the table of lanes.
struct Column {
    std::string group = "Other";  ///< columns of one group are together; empty: none
    std::string head{};           ///< empty: the measure's title
};

/// The value in the line above the plots.
struct Headline {
    std::string symbol{};  ///< empty: it is not there
    int digits = 3;
    std::string unit{};
};

/// The tables of the command line that have a measure as a column where --measures picks none.
struct Tables {
    bool run = true, compare = true, experiment = true;
    bool timing = false;  ///< a row of `whorl run --timing`, a median over the run
};

struct Measure {
    std::string key;                     ///< in tables, lessons and on the command line
    std::vector<std::string> aliases{};  ///< keys that it had, which are still read
    std::string title, unit;
    std::string help;  ///< a sentence without its full stop
    std::string source{};
    Needs needs = Needs::Nothing;
    /// Adds a row of cells to its sums; worked out only while something asks for the measure. Null: what a
    /// step knows anyway is enough.
    std::function<void(const RowView&, Sums&)> row{};
    /// From a step and those sums. NaN where there is none.
    std::function<double(const Measures&, const Sums&)> value;
    Best best = Best::None;
    Mean mean = Mean::None;
    bool timing = false;  ///< a time of the machine's: in no picture and no lesson
    Tables tables{};
    Plotting plot{};
    Column column{};
    Headline headline{};

    /// The value in a step; NaN too where its sums were not asked for.
    double of(const Measures& step) const;
    /// Whether steps work it out only while it is asked for.
    bool on_demand() const { return row || needs == Needs::LimiterMasks; }

    const std::string& chart() const { return plot.chart.empty() ? title : plot.chart; }
    const std::string& label() const { return plot.label.empty() ? title : plot.label; }
    const std::string& head() const { return column.head.empty() ? title : column.head; }
};

/// All measures, in the order of tables. Everything that shows or names one asks this list.
Registry<Measure>& measures();

}  // namespace whorl
