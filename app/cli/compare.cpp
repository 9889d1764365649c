// `whorl compare`: a contact sheet, and the numbers beside it.
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/cli/headless.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "app/scenes/comparisons.h"
#include "core/base/error.h"
#include "core/io/series.h"

namespace whorl::app {
namespace {

/// The effective viscosity of each lane, meant over the steps since it was last asked for: a single step's
/// says more of that step than of the scheme.
class Viscosities {
  public:
    explicit Viscosities(std::size_t lanes) : sums_(lanes), steps_(lanes) {}
    void add(const Session& session) {
        for (std::size_t k = 0; k < sums_.size(); ++k) {
            const double viscosity = session.measures(k).effective_viscosity;
            if (!std::isfinite(viscosity)) continue;
            sums_[k] += viscosity;
            steps_[k] += 1;
        }
    }
    double take(std::size_t k) { return std::exchange(sums_[k], 0) / std::exchange(steps_[k], 0); }

  private:
    std::vector<double> sums_, steps_;
};

constexpr const char* columns =
    "lane,step,time,density_percent,kinetic_energy,enstrophy,min,max,L1,L2,Linf,effective_viscosity";

void write_rows(Series& csv, const SessionSnapshot& s, Viscosities& viscosities) {
    const std::vector<std::string> names = titles(s.setup);
    for (std::size_t k = 0; k < s.lanes.size(); ++k) {
        const Measures& m = s.lanes[k].measures;
        const double row[] = {static_cast<double>(s.step),
                              m.time,
                              m.density_percent,
                              m.kinetic_energy,
                              m.enstrophy,
                              m.min_density,
                              m.max_density,
                              m.errors.L1,
                              m.errors.L2,
                              m.errors.Linf,
                              viscosities.take(k)};
        csv.row({names[k]}, row);
    }
}

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
    std::optional<Series> csv;
    if (!arguments.csv.empty()) csv.emplace(arguments.csv, columns);

    Pool pool(arguments.threads);
    std::optional<Drawing> drawing;
    if (!arguments.out.empty()) drawing.emplace(arguments.draw);
    Session session(recording, pool);
    std::vector<SessionSnapshot> rows;
    Viscosities viscosities(session.lane_count());
    {
        Progress progress(arguments.scene, at.back());
        for (const int step : at) {
            while (session.step_number() < step) {
                session.step();
                viscosities.add(session);
                progress.at(session.step_number());
            }
            SessionSnapshot& row = rows.emplace_back();
            take_shown(session, view(arguments.draw.view), rows.size() > 1 ? rows[rows.size() - 2] : row,
                       pool, row);
            if (csv) write_rows(*csv, row, viscosities);
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
