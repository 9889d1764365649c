#include "app/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "app/cli/refusals.h"
#include "core/base/error.h"
#include "core/session/recording.h"

namespace whorl::app {
namespace {

constexpr const char* about =
    "Whorl shows what a fluid solver does to its smoke.\n"
    "Without a verb it opens the window on a preset, an experiment or a file.";

constexpr const char* examples =
    "\nExamples:\n"
    "  whorl                                   the rising plume, in a window\n"
    "  whorl run plume --steps 480 --picture plume.png --set advector=aslam\n"
    "  whorl experiment rotation --set advector=aslam --at 600,1200\n"
    "  whorl compare plume --lanes thesis-five --out sheet.png\n"
    "  whorl explain plume --at 200 --cell 60,30 --set interpolation=fritsch-carlson\n"
    "  whorl converge rotation --set advector=aslam --resolutions 40,80,160\n"
    "  whorl lesson smear\n"
    "  whorl list parameters";

/// Says in Whorl's own words what an option's number would be.
template <class Number>
CLI::Validator within(Number least, Number most) {
    const std::string range = CLI::detail::to_string(least) + " to " + CLI::detail::to_string(most);
    const auto check = [=](const std::string& text) -> std::string {
        Number number{};
        const char* const end = text.data() + text.size();
        const auto [next, error] = std::from_chars(text.data(), end, number);
        if (error == std::errc{} && next == end && number >= least && number <= most) return {};
        return "\"" + text + "\" is not a " + (std::is_integral_v<Number> ? "whole number" : "number") +
               " from " + range;
    };
    return CLI::Validator(check, range);
}

/// A name that is none would silently leave the option out.
CLI::Validator named() {
    return CLI::Validator([](const std::string& text) { return text.empty() ? "it lacks its value" : ""; },
                          "");
}

void add_set(CLI::App& verb, std::vector<std::string>& set) {
    verb.add_option("--set", set, "set a parameter, key=value; `whorl list parameters` shows them")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
}

void add_threads(CLI::App& verb, int& threads) {
    verb.add_option("--threads", threads, "threads that step; results do not depend on it")
        ->type_name("N")
        ->check(within(1, 256));
}

void add_draw(CLI::App& verb, DrawArguments& draw) {
    verb.add_option("--view", draw.view, "what the picture shows")->type_name("VIEW")->check(named());
    verb.add_option("--map", draw.map, "colours of the picture")->type_name("MAP")->check(named());
    verb.add_option("--range", draw.range, "values at the ends of the colours; else all that occur")
        ->type_name("LO,HI")
        ->check(named());
    verb.add_option("--width", draw.width, "pixels across a field")->type_name("N")->check(within(100, 8000));
    verb.add_option("--scale", draw.scale, "size of letters and lines; else what suits the width")
        ->type_name("S")
        ->check(within(0.5, 8.0));
    verb.add_flag("--light", draw.light, "dark on white, for paper");
    verb.add_flag("--difference", draw.difference, "each lane less the reference lane, or the first");
    verb.add_flag("--crisp", draw.crisp, "cells as squares of one colour");
}

void add_csv(CLI::App& verb, std::string& csv, std::string& measures, const char* help) {
    verb.add_option("--csv", csv, help)->type_name("FILE|-")->check(named());
    verb.add_option("--measures", measures, "the columns of --csv; `whorl list measures` shows them")
        ->type_name("KEY,KEY...")
        ->check(named());
}

void add_outputs(CLI::App& verb, RunArguments& run) {
    add_csv(verb, run.csv, run.measures, "write a row a step; - is standard output");
    verb.add_option("--picture", run.picture,
                    "draw the last step as a PNG, which `whorl FILE.png` opens again")
        ->type_name("FILE.png")
        ->check(named());
    add_draw(verb, run.draw);
}

void add_lanes(CLI::App& verb, std::string& lanes) {
    verb.add_option("--lanes", lanes, "run these side by side; `whorl list comparisons` shows them")
        ->type_name("KEY|FILE")
        ->check(named());
}

constexpr const char* scene_help =
    "a preset, an experiment, a file of a scene or a run, or a picture of Whorl's";
constexpr const char* scene_type = "PRESET|FILE";

void add_scene(CLI::App& verb, std::string& scene) {
    verb.add_option("scene", scene, scene_help)->type_name(scene_type)->required();
}

/// "40,80,160" as numbers.  @throws InputError
std::vector<int> whole_numbers(const std::string& option, const std::string& text,
                               const std::string& example = "600,1200") {
    std::vector<int> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (;;) {
        int number = 0;
        const auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc{} || number < 0 || (next != end && *next != ',')) {
            throw InputError(option + " = \"" + text + "\" is not a list of whole numbers, 0 or more, as " +
                             example);
        }
        numbers.push_back(number);
        if (next == end) return numbers;
        at = next + 1;
    }
}

CLI::App* add_run(CLI::App& app, RunArguments& run) {
    CLI::App* verb = app.add_subcommand("run", "run a scene without a window");
    add_scene(*verb, run.scene);
    verb->add_option("--steps", run.steps,
                     "how many steps; else up to where it was recorded, or the scene's own")
        ->type_name("N")
        ->check(within<long>(0, Recording::max_step));
    add_set(*verb, run.set);
    add_lanes(*verb, run.lanes);
    add_outputs(*verb, run);
    verb->add_option("--timing", run.timing, "write the median ms of each phase; - is standard output")
        ->type_name("FILE|-")
        ->check(named());
    verb->add_option("--save", run.save, "write the run itself")->type_name("FILE.toml")->check(named());
    verb->add_option("--animate", run.animate, "make a film; MP4 and GIF need ffmpeg")
        ->type_name("FILE.mp4|FILE.gif|%04d.png")
        ->check(named());
    verb->add_option("--every", run.every, "steps between two frames of the film")
        ->type_name("N")
        ->check(within(1, 100000));
    verb->add_option("--fps", run.fps, "frames of the film a second")->type_name("N")->check(within(1, 240));
    verb->add_flag("--limiters", run.limiters, "count in --csv the nodes that limiters change in each step");
    verb->add_flag("--digest", run.digest, "print a number made from every bit of the fields");
    add_threads(*verb, run.threads);
    return verb;
}

CLI::App* add_compare(CLI::App& app, CompareArguments& compare, std::string& at) {
    CLI::App* verb = app.add_subcommand(
        "compare", "a contact sheet: a row a step, a column a lane, as the thesis' figure 5.21");
    add_scene(*verb, compare.scene);
    add_lanes(*verb, compare.lanes);
    verb->add_option("--at", at, "steps to show; 120,240,360,480,600 if not given")
        ->type_name("STEP,STEP...");
    verb->add_option("--out", compare.out, "the sheet")->type_name("FILE.png")->check(named());
    add_csv(*verb, compare.csv, compare.measures, "write a row a step and lane; - is standard output");
    add_set(*verb, compare.set);
    add_draw(*verb, compare.draw);
    add_threads(*verb, compare.threads);
    return verb;
}

CLI::App* add_explain(CLI::App& app, ExplainArguments& explain, std::string& cell) {
    CLI::App* verb = app.add_subcommand("explain", "how a step made one value, as sums with numbers");
    add_scene(*verb, explain.scene);
    verb->add_option("--at", explain.at, "the step")
        ->type_name("STEP")
        ->check(within<long>(1, Recording::max_step))
        ->required();
    verb->add_option("--cell", cell, "column and row, from 0 at the lower left; a face's for u and v")
        ->type_name("I,J")
        ->required();
    verb->add_option("--field", explain.field, "density, temperature, u or v")->type_name("FIELD");
    add_set(*verb, explain.set);
    add_lanes(*verb, explain.lanes);
    add_threads(*verb, explain.threads);
    return verb;
}

CLI::App* add_experiment(CLI::App& app, ExperimentArguments& experiment, std::string& at) {
    CLI::App* verb = app.add_subcommand("experiment", "run a test and measure its errors");
    verb->add_option("name", experiment.scene, "`whorl list experiments` shows them")
        ->type_name("NAME")
        ->required();
    verb->add_option("--at", at, "steps to report; the last one ends the run")->type_name("STEP,STEP...");
    verb->add_option("--steps", experiment.steps, "how many steps; else the experiment's own")
        ->type_name("N")
        ->check(within<long>(0, Recording::max_step));
    add_set(*verb, experiment.set);
    add_outputs(*verb, experiment);
    add_threads(*verb, experiment.threads);
    return verb;
}

CLI::App* add_converge(CLI::App& app, ConvergeArguments& converge, std::string& resolutions) {
    CLI::App* verb =
        app.add_subcommand("converge", "errors and rates under refinement, as the thesis' table 5.2");
    verb->add_option("experiment", converge.experiment, "an experiment with an exact solution")
        ->type_name("NAME")
        ->required();
    verb->add_option("--resolutions", resolutions, "cells along the width, each a multiple of the last")
        ->type_name("N,N...");
    add_set(*verb, converge.set);
    add_threads(*verb, converge.threads);
    return verb;
}

CLI::App* add_list(CLI::App& app, ListArguments& list) {
    CLI::App* verb = app.add_subcommand("list", "what there is to choose from");
    verb->add_option("what", list.what, "advectors, interpolations, presets, parameters ...")
        ->type_name("WHAT");
    return verb;
}

CLI::App* add_lesson(CLI::App& app, LessonArguments& lesson) {
    CLI::App* verb = app.add_subcommand(
        "lesson", "what there is to learn: a list, a lesson's text, or a check of its claims");
    verb->add_option("lesson", lesson.lesson, "a lesson, or a file of one; else all")
        ->type_name("KEY|FILE")
        ->check(named());
    verb->add_flag("--check", lesson.check, "run the steps and check what they claim");
    verb->add_option("--pictures", lesson.pictures, "draw each step's moment into this folder")
        ->type_name("FOLDER")
        ->check(named());
    add_threads(*verb, lesson.threads);
    return verb;
}

void add_window(CLI::App& app, WindowArguments& window) {
    app.add_option("scene", window.scene, std::string(scene_help) + "; or a lesson's file")
        ->type_name(scene_type);
    add_set(app, window.set);
    add_lanes(app, window.lanes);
    add_threads(app, window.threads);
    app.add_option("--size", window.size, "size of the window")->type_name("WxH");
    app.add_flag_callback(
        "--tour", [&] { window.tour = true; }, "begin with the tour, which else comes at the first start");
    app.add_flag_callback(
        "--no-tour", [&] { window.tour = false; }, "begin without it");
    app.add_option("--trace", window.trace, "append what happens, for tests")->type_name("FILE")->group("");
    app.add_option("--content-scale", window.content_scale, "as if the monitor had it")->group("");
}

}  // namespace

Arguments parse_arguments(int argc, char** argv) {
    CLI::App app(about, "whorl");
    app.footer(examples);
    app.set_version_flag("--version", "whorl " WHORL_VERSION);

    WindowArguments window;
    add_window(app, window);
    RunArguments run;
    const CLI::App* run_verb = add_run(app, run);
    CompareArguments compare;
    std::string compare_at = "120,240,360,480,600";
    const CLI::App* compare_verb = add_compare(app, compare, compare_at);
    ExplainArguments explain;
    std::string cell;
    const CLI::App* explain_verb = add_explain(app, explain, cell);
    ExperimentArguments experiment;
    std::string at;
    const CLI::App* experiment_verb = add_experiment(app, experiment, at);
    ConvergeArguments converge;
    std::string resolutions = "40,80,160";
    const CLI::App* converge_verb = add_converge(app, converge, resolutions);
    ListArguments list;
    const CLI::App* list_verb = add_list(app, list);
    LessonArguments lesson;
    const CLI::App* lesson_verb = add_lesson(app, lesson);

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& e) {
        return app.exit(e);
    } catch (const CLI::ExtrasError&) {
        return refuse(app, unexpected(app));
    } catch (const CLI::ArgumentMismatch& e) {
        return refuse(app, mismatch(e.what()));
    } catch (const CLI::ParseError& e) {
        return refuse(app, e.what());
    }
    if (const auto reason = misplaced(app)) return refuse(app, *reason);
    if (run_verb->parsed()) return run;
    if (experiment_verb->parsed()) {
        if (!at.empty()) experiment.at = whole_numbers("--at", at);
        return experiment;
    }
    if (compare_verb->parsed()) {
        compare.at = whole_numbers("--at", compare_at);
        return compare;
    }
    if (explain_verb->parsed()) {
        explain.cell = whole_numbers("--cell", cell, "20,12");
        return explain;
    }
    if (converge_verb->parsed()) {
        converge.resolutions = whole_numbers("--resolutions", resolutions, "40,80,160");
        return converge;
    }
    if (list_verb->parsed()) return list;
    if (lesson_verb->parsed()) return lesson;
    return window;
}

}  // namespace whorl::app
