// `whorl run`: a scene, or a recorded run, without a window.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "app/cli/exit_code.h"
#include "app/cli/headless.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "app/film/film.h"
#include "app/plot/ticks.h"
#include "core/io/run_file.h"
#include "core/io/series.h"
#include "core/scene/error.h"

namespace whorl::app {
namespace {

/// A row a step, or with several lanes a row a step and lane.
class Rows {
  public:
    Rows(const std::string& file, const Setup& setup, bool limited)
        : names_(titles(setup)),
          limited_(limited),
          series_(file, std::string(names_.size() > 1 ? "lane," : "") + columns +
                            (limited ? ",limited_density,limited_velocity" : "")) {}
    void add(const Session& session) {
        for (std::size_t k = 0; k < session.lane_count(); ++k) {
            const Measures& m = session.measures(k);
            const double row[] = {static_cast<double>(session.step_number()),
                                  m.time,
                                  m.density_percent,
                                  m.kinetic_energy,
                                  m.enstrophy,
                                  m.divergence_after,
                                  m.min_density,
                                  m.max_density,
                                  m.limited.density,
                                  m.limited.velocity};
            const std::span<const double> shown = std::span(row).first(std::size(row) - (limited_ ? 0 : 2));
            if (names_.size() > 1) {
                series_.row(k < names_.size() ? names_[k] : std::to_string(k + 1), shown);
            } else {
                series_.row(shown);
            }
        }
    }
    void finish() { series_.finish(); }

  private:
    static constexpr const char* columns =
        "step,time,density_percent,kinetic_energy,enstrophy,max_divergence,min,max";
    std::vector<std::string> names_;
    bool limited_;
    Series series_;
};

/// Medians over the steps of a run, row by row.
class Timing {
  public:
    explicit Timing(long steps) { steps_.reserve(static_cast<std::size_t>(steps)); }
    void add(const Measures& m) { steps_.push_back({m.ms, m.pressure}); }
    void write(const std::string& file) const {
        Series series(file, "phase,median_ms");
        series.row("forces", median([](const Step& s) { return s.ms.forces; }));
        series.row("projection", median([](const Step& s) { return s.ms.projection; }));
        series.row("advection", median([](const Step& s) { return s.ms.advection; }));
        series.row("total", median([](const Step& s) { return s.ms.total; }));
        // Within the projection; the last two are no times.
        series.row("pressure_setup", median([](const Step& s) { return s.pressure.setup_ms; }));
        series.row("pressure_solve", median([](const Step& s) { return s.pressure.solve_ms; }));
        series.row("pressure_iterations", median([](const Step& s) { return s.pressure.iterations; }));
        series.row("pressure_residual", median([](const Step& s) { return s.pressure.residual; }));
        series.finish();
    }

  private:
    struct Step {
        PhaseTimes ms;
        SolveReport pressure;
    };
    template <class Figure>
    double median(Figure&& figure) const {
        if (steps_.empty()) return 0;
        std::vector<double> values;
        values.reserve(steps_.size());
        for (const Step& step : steps_) values.push_back(figure(step));
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    }
    std::vector<Step> steps_;
};

/// Frames of the steps that a film shows. Its colours take in what they have seen: they do not flicker.
class Filming {
  public:
    Filming(const RunArguments& arguments, Pool& pool)
        : film_(arguments.animate, arguments.fps),
          every_(arguments.every),
          pool_(pool),
          drawing_(arguments.draw),
          view_(view(arguments.draw.view)) {}
    void add(Session& session) {
        if (session.step_number() % every_ != 0) return;
        take_shown(session, view_, snapshot_, pool_, snapshot_);
        const Range now = drawing_.span(snapshot_);
        seen_ = seen_ ? Range{std::min(seen_->lo, now.lo), std::max(seen_->hi, now.hi)} : now;
        film_.add(drawing_.draw({&snapshot_, 1}, seen_));
    }
    void finish() { film_.finish(); }

  private:
    Film film_;
    int every_;
    Pool& pool_;
    Drawing drawing_;
    const View& view_;
    SessionSnapshot snapshot_;
    std::optional<Range> seen_;
};

void check(const RunArguments& a) {
    if (!a.picture.empty()) check_picture("--picture", a.picture);
    if (a.picture.empty() && a.animate.empty() &&
        (a.draw.view != "density" || !a.draw.map.empty() || a.draw.difference))
        throw InputError("--view, --map and --difference are of the picture; give --picture FILE.png too");
    if (!a.save.empty() && !a.save.ends_with(".toml"))
        throw InputError("--save = " + a.save + ": runs are TOML; give a name that ends in .toml");
    if (a.limiters && a.csv.empty())
        throw InputError("--limiters adds to the rows of --csv; give --csv FILE too");
    for (const std::string& file : {a.csv, a.timing, a.save}) {
        if (!file.empty() && file != "-") check_writable(file);
    }
}

void say_summary(const std::string& scene, const Session& session) {
    const std::vector<std::string> names = titles(session.setup());
    for (std::size_t k = 0; k < session.lane_count(); ++k) {
        const Measures& m = session.measures(k);
        const std::string smoke = std::isfinite(m.density_percent)
                                      ? "density " + figure(m.density_percent) + " % of what was put in"
                                      : "no smoke";
        const std::string name = session.lane_count() > 1 ? names[k] : scene;
        std::printf("%s: step %ld, t = %g, %s, kinetic energy %.4g, enstrophy %.4g\n", name.c_str(),
                    session.step_number(), m.time, smoke.c_str(), m.kinetic_energy, m.enstrophy);
    }
}

/// Says which lanes have stopped.  @throws NotFinite if none goes on
void check_lanes(const Session& session) {
    for (std::size_t k = 0; k < session.lane_count() && !session.sound(); ++k) {
        if (const auto& failure = session.lane(k).failure()) throw NotFinite(*failure);
    }
}

void say_stopped(const Session& session) {
    const std::vector<std::string> names = titles(session.setup());
    for (std::size_t k = 0; k < session.lane_count(); ++k) {
        if (const auto& failure = session.lane(k).failure())
            std::fprintf(stderr, "whorl: %s stopped: %s\n", names[k].c_str(), failure->c_str());
    }
}

/// @return whether a recording's digest, if there is one, is this session's
bool check_digest(const Session& session, std::uint64_t recorded, bool print) {
    const std::uint64_t now = session.digest();
    if (print) std::printf("digest: %016llx\n", static_cast<unsigned long long>(now));
    if (recorded == 0) return true;
    std::fprintf(stderr, now == recorded ? "the same bits as were recorded\n"
                                         : "whorl: these are not the bits that were recorded\n");
    return now == recorded;
}

}  // namespace

int run_scene(const RunArguments& arguments) {
    const Recording recording = recording_for(arguments.scene, arguments.lanes, arguments.set);
    const long own = recording.step > 0 ? recording.step : recording.setup.scene.steps;
    const long steps = arguments.steps ? *arguments.steps : own;
    check(arguments);

    Pool pool(arguments.threads);
    std::optional<Drawing> drawing;
    if (!arguments.picture.empty()) drawing.emplace(arguments.draw);
    Session session(recording, pool);
    std::optional<Filming> film;
    if (!arguments.animate.empty()) film.emplace(arguments, pool);
    std::optional<Rows> csv;
    if (!arguments.csv.empty()) csv.emplace(arguments.csv, recording.setup, arguments.limiters);
    session.watch_limiters(csv && arguments.limiters);
    Timing timing(steps);
    {
        Progress progress(arguments.scene, steps);
        if (film) film->add(session);
        while (session.step_number() < steps) {
            session.step();
            check_lanes(session);
            timing.add(session.measures(0));
            if (csv) csv->add(session);
            if (film) film->add(session);
            progress.at(session.step_number());
        }
    }
    say_stopped(session);
    if (csv) csv->finish();
    if (!arguments.timing.empty()) timing.write(arguments.timing);
    if (film) {
        film->finish();
        say_written("film", arguments.animate);
    }
    Recording done = session.recording();
    done.digest = session.digest();
    if (!arguments.save.empty()) {
        write_whole_file(arguments.save, write_run(done));
        say_written("run", arguments.save);
    }
    if (drawing) {
        SessionSnapshot last;
        take_shown(session, view(arguments.draw.view), last, pool, last);
        write_picture(arguments.picture, drawing->draw({&last, 1}), done);
    }
    if (arguments.csv.empty() && arguments.timing.empty()) say_summary(arguments.scene, session);
    const bool same = check_digest(session, steps == recording.step ? recording.digest : 0, arguments.digest);
    return same ? 0 : exit_failed;
}

}  // namespace whorl::app
