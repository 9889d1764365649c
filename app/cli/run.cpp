// `whorl run`: a scene, or a recorded run, without a window.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "app/cli/exit_code.h"
#include "app/cli/headless.h"
#include "app/cli/progress.h"
#include "app/cli/run_tables.h"
#include "app/cli/verbs.h"
#include "app/film/film.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/io/run_file.h"

namespace whorl::app {
namespace {

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

/// Two files of one name: the later one would take the other's place.
void check_different(std::initializer_list<std::pair<const char*, const std::string&>> files) {
    for (const auto& [option, file] : files) {
        for (const auto& [other, same] : files) {
            if (&file != &same && !file.empty() && file == same)
                throw InputError(std::string(option) + " and " + other + " name the same file, " + file);
        }
    }
}

void check(const RunArguments& a) {
    if (!a.picture.empty()) check_picture("--picture", a.picture);
    if (a.picture.empty() && a.animate.empty() && !(a.draw == DrawArguments()))
        throw InputError(
            "--view, --map, --range, --width, --scale, --light, --crisp and --difference are of the picture; "
            "give --picture FILE.png too");
    if (!a.animate.empty()) check_film_name("--animate", a.animate);
    check_different({{"--csv", a.csv},
                     {"--timing", a.timing},
                     {"--save", a.save},
                     {"--picture", a.picture},
                     {"--animate", a.animate}});
    if (!a.save.empty() && !a.save.ends_with(".toml"))
        throw InputError("--save = " + a.save + ": runs are TOML; give a name that ends in .toml");
    if (a.limiters && a.csv.empty())
        throw InputError("--limiters adds to the rows of --csv; give --csv FILE too");
    if (!a.measures.empty() && a.csv.empty())
        throw InputError("--measures picks the columns of --csv; give --csv FILE too");
    for (const std::string& file : {a.csv, a.timing, a.save}) {
        if (!file.empty() && file != "-") check_writable(file);
    }
}

void say_summary(const std::string& scene, const Session& session) {
    const std::vector<std::string> names = titles(session.setup());
    for (std::size_t k = 0; k < session.lane_count(); ++k) {
        const Measures& m = session.measures(k);
        const std::string smoke = std::isfinite(m.density_percent())
                                      ? "density " + figure(m.density_percent()) + " % of what was put in"
                                      : "no smoke";
        const std::string name = session.lane_count() > 1 ? names[k] : scene;
        std::printf("%s: step %ld, t = %g, %s, kinetic energy %.4g, enstrophy %.4g\n", name.c_str(),
                    session.step_number(), m.time, smoke.c_str(), m.kinetic_energy, m.enstrophy);
    }
}

/// Says which lanes have stopped.  @throws NotFinite if none goes on
void check_lanes(const Session& session) {
    for (std::size_t k = 0; k < session.lane_count() && !session.running(); ++k) {
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
    Columns columns(&Tables::run, arguments.measures,
                    arguments.limiters ? Needs::LimiterMasks : Needs::Nothing);

    Pool pool(arguments.threads);
    std::optional<Drawing> drawing;
    if (!arguments.picture.empty()) drawing.emplace(arguments.draw);
    Session session(recording, pool);
    std::optional<Filming> film;
    if (!arguments.animate.empty()) film.emplace(arguments, pool);
    RowNames names(recording);
    std::optional<Rows> csv;
    if (!arguments.csv.empty()) {
        session.ask(columns.all());
        csv.emplace(arguments.csv, names, std::move(columns));
    }
    Timings timings(names);
    {
        Progress progress(arguments.scene, steps);
        if (film) film->add(session);
        while (session.step_number() < steps) {
            session.step();
            check_lanes(session);
            timings.add(session);
            if (csv) csv->add(session);
            if (film) film->add(session);
            progress.at(session.step_number());
        }
    }
    say_stopped(session);
    if (csv) csv->finish();
    if (!arguments.timing.empty()) timings.write(arguments.timing);
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
    for (const std::string& table : {arguments.csv, arguments.timing}) {
        if (!table.empty() && table != "-") say_written("table", table);
    }
    if (arguments.csv != "-" && arguments.timing != "-") say_summary(arguments.scene, session);
    const bool same = check_digest(session, steps == recording.step ? recording.digest : 0, arguments.digest);
    return same ? 0 : exit_failed;
}

}  // namespace whorl::app
