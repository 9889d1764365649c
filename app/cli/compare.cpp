// `whorl compare`: a contact sheet, and the numbers beside it.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "app/cli/columns.h"
#include "app/cli/headless.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "app/scenes/comparisons.h"
#include "core/base/error.h"
#include "core/io/series.h"

namespace whorl::app {
namespace {

/// The rows of a table: what says little of one step is meant over the steps since the last row.
class CompareRows {
  public:
    /// @throws std::runtime_error as Series
    CompareRows(const std::string& file, Columns columns)
        : columns_(std::move(columns)), csv_(file, "lane," + columns_.header()) {}

    void add(const Session& session) {
        for (std::size_t k = 0; k < session.lane_count(); ++k) {
            std::vector<Sum>& sums = sums_of(session.id(k));
            for (std::size_t c = 0; c < sums.size(); ++c) {
                const Measure& measure = *columns_.all()[c];
                if (measure.mean == Mean::OverSteps) sums[c].add(measure.of(session.measures(k)));
            }
        }
    }
    void write(const Session& session) {
        const std::vector<std::string> names = titles(session.setup());
        for (std::size_t k = 0; k < session.lane_count(); ++k) {
            std::vector<Sum>& sums = sums_of(session.id(k));
            std::vector<double> row = columns_.row(session.step_number(), session.measures(k));
            const std::size_t first = row.size() - sums.size();
            for (std::size_t c = 0; c < sums.size(); ++c) {
                if (columns_.all()[c]->mean == Mean::OverSteps) row[first + c] = sums[c].take();
            }
            csv_.row({names[k]}, row);
        }
    }
    void finish() { csv_.finish(); }

  private:
    struct Sum {
        double sum = 0, count = 0;
        void add(double value) {
            if (!std::isfinite(value)) return;
            sum += value;
            count += 1;
        }
        double take() { return std::exchange(sum, 0) / std::exchange(count, 0); }
    };

    /// One for each column.
    std::vector<Sum>& sums_of(int lane) {
        return sums_.try_emplace(lane, columns_.all().size()).first->second;
    }

    Columns columns_;
    Series csv_;
    std::map<int, std::vector<Sum>> sums_;  // by Session::id
};

/// A scene of a single lane is compared by the schemes of the thesis.
std::string lanes_for(const CompareArguments& arguments) {
    if (!arguments.lanes.empty()) return arguments.lanes;
    const bool one = recording_for(arguments.scene, "", arguments.set).setup.lanes.size() == 1;
    return one ? std::string(comparisons().front().key) : "";
}

}  // namespace

int run_compare(const CompareArguments& arguments) {
    const std::vector<int>& at = arguments.at;
    if (!std::is_sorted(at.begin(), at.end()) || std::adjacent_find(at.begin(), at.end()) != at.end())
        throw InputError("--at gives steps that rise, as 120,240,360");
    if (arguments.out.empty() && arguments.csv.empty())
        throw InputError("give --out FILE.png for the sheet, --csv FILE for its numbers, or both");
    const Recording recording = recording_for(arguments.scene, lanes_for(arguments), arguments.set);
    if (!arguments.out.empty()) check_picture("--out", arguments.out);
    const Columns columns(&Tables::compare, arguments.measures);
    if (!arguments.measures.empty() && arguments.csv.empty())
        throw InputError("--measures picks the columns of --csv; give --csv FILE too");
    std::optional<CompareRows> csv;
    if (!arguments.csv.empty()) csv.emplace(arguments.csv, columns);

    Pool pool(arguments.threads);
    std::optional<Drawing> drawing;
    if (!arguments.out.empty()) drawing.emplace(arguments.draw);
    Session session(recording, pool);
    std::vector<SessionSnapshot> rows;
    if (csv) session.ask(columns.all());
    {
        Progress progress(arguments.scene, at.back());
        for (const int step : at) {
            while (session.step_number() < step) {
                session.step();
                if (csv) csv->add(session);
                progress.at(session.step_number());
            }
            SessionSnapshot& row = rows.emplace_back();
            take_shown(session, view(arguments.draw.view), rows.size() > 1 ? rows[rows.size() - 2] : row,
                       pool, row);
            if (csv) csv->write(session);
        }
    }
    if (csv) {
        csv->finish();
        say_written("table", arguments.csv);
    }
    if (drawing) {
        Recording done = session.recording();
        done.digest = session.digest();
        write_picture(arguments.out, drawing->draw(rows), done);
    }
    return 0;
}

}  // namespace whorl::app
