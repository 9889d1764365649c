// Lessons from TOML.
#include <algorithm>
#include <limits>

#include "app/lessons/lesson.h"
#include "app/scenes/comparisons.h"
#include "app/scenes/presets.h"
#include "core/io/lane_table.h"
#include "core/scene/parameters.h"

namespace whorl::app {
namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 20;
constexpr std::size_t max_steps = 100, max_claims = 100, max_tries = 20;  // of a lesson, of a step
constexpr long max_run = 10'000;                                          // steps of a run
constexpr int lesson_version = 1;

using toml::node;
using toml::table;

/// Calls `read()` and says of what it refuses where that stands.
template <class Read>
decltype(auto) located(const TomlReader& reader, const node& at, Read&& read) {
    try {
        return read();
    } catch (const InputError& e) {
        reader.fail(at.source(), e.what());
    }
}

/// A text to be shown: without control characters, but for ends of lines where they are allowed.
std::string words(const TomlReader& reader, const node& at, const std::string& key, bool lines = false) {
    std::string text = reader.string(at, key);
    if (text.find_first_not_of(" \t\r\n") == text.npos) reader.fail(at.source(), key + " is empty");
    for (const char c : text) {
        const bool end = c == '\n' || c == '\r' || c == '\t';
        if ((static_cast<unsigned char>(c) < ' ' && !(end && lines)) || c == '\x7f')
            reader.fail(at.source(), key + (end ? " is more than one line" : " holds a control character"));
    }
    return text;
}

const node& required(const TomlReader& reader, const table& in, std::string_view key, const std::string& of) {
    const node* at = in.get(key);
    if (at == nullptr) reader.fail(in.source(), of + " has no " + std::string(key));
    return *at;
}

LessonMode read_mode(const TomlReader& reader, const node& at) {
    static constexpr std::string_view modes[] = {"side by side", "one", "wipe", "difference"};
    const std::string key = reader.string(at, "mode");
    for (std::size_t k = 0; k < std::size(modes); ++k) {
        if (modes[k] == key) return static_cast<LessonMode>(k);
    }
    reader.fail(at.source(), "unknown mode \"" + key + "\"; " + suggestion(key, modes));
}

std::vector<std::string> read_tries(const TomlReader& reader, const node& at) {
    const toml::array* array = at.as_array();
    if (array == nullptr || array->size() > max_tries)
        reader.fail(at.source(),
                    "try is a list of at most " + std::to_string(max_tries) + " texts: write [\"…\"]");
    std::vector<std::string> tries;
    for (const node& item : *array) tries.push_back(words(reader, item, "an item of try"));
    return tries;
}

std::size_t read_lane_name(const TomlReader& reader, const node& at, const std::string& key,
                           const Setup& setup) {
    const std::string name = reader.string(at, key);
    const std::vector<std::string> names = titles(setup);
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (names[k] == name) return k;
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    reader.fail(at.source(), "no lane is called \"" + name + "\"; " + suggestion(name, known));
}

Claim read_claim(const TomlReader& reader, const table& from, const LessonStep& step) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const Setup& setup = step.recording.setup;
    Claim claim{.measure = nullptr,
                .place = {0, step.recording.step},
                .over = {},
                .least = -unlimited,
                .most = unlimited,
                .line = from.source().begin.line,
                .column = from.source().begin.column};
    std::optional<std::size_t> lane, over_lane;
    std::optional<long> over_step;
    std::optional<double> is, within;
    const auto to_lane = [&](std::optional<std::size_t>& out, const std::string& key) {
        return [&, key](const node& n) { out = read_lane_name(reader, n, key, setup); };
    };
    reader.keys(from,
                {{"measure",
                  [&](const node& n) {
                      const std::string key = reader.string(n, "measure");
                      claim.measure =
                          &located(reader, n, [&]() -> const Measure& { return claimed_measure(key); });
                  }},
                 {"lane", to_lane(lane, "lane")},
                 {"at", [&](const node& n) { claim.place.step = reader.integer(n, "at", 0, max_run); }},
                 {"over_lane", to_lane(over_lane, "over_lane")},
                 {"over_at", [&](const node& n) { over_step = reader.integer(n, "over_at", 0, max_run); }},
                 {"is", [&](const node& n) { is = reader.number(n, "is"); }},
                 {"within", [&](const node& n) { within = reader.number(n, "within"); }},
                 {"at_least", [&](const node& n) { claim.least = reader.number(n, "at_least"); }},
                 {"at_most", [&](const node& n) { claim.most = reader.number(n, "at_most"); }}});
    required(reader, from, "measure", "a claim");
    if (!lane && setup.lanes.size() > 1) required(reader, from, "lane", "a claim about several lanes");
    claim.place.lane = lane.value_or(0);
    if (over_lane || over_step)
        claim.over = {over_lane.value_or(claim.place.lane), over_step.value_or(claim.place.step)};
    const bool about = is && within && *within >= 0;
    const bool bounded = claim.least > -unlimited || claim.most < unlimited;
    if (about == bounded || is.has_value() != within.has_value() || claim.least > claim.most)
        reader.fail(from.source(), "a claim says is and within, or at_least, at_most or both");
    if (about) {
        claim.least = *is - *within;
        claim.most = *is + *within;
    }
    return claim;
}

/// Reads lanes, no two of one name: a claim could not say which of them it means.
std::vector<LaneSetup> read_named_lanes(const TomlReader& reader, const node& at) {
    std::vector<LaneSetup> lanes = read_lanes(reader, at);
    for (std::size_t k = 0; k < lanes.size(); ++k) {
        const auto here = lanes.begin() + static_cast<std::ptrdiff_t>(k);
        const auto same = [&](const LaneSetup& lane) { return lane.name == here->name; };
        if (here->name.empty() || std::none_of(lanes.begin(), here, same)) continue;
        const table& written = *at.as_array()->get(k)->as_table();
        reader.fail(written.get("name")->source(), "two lanes of a step are called \"" + here->name + "\"");
    }
    return lanes;
}

/// What a step runs: the scene first, then what it sets, then its lanes.
void read_run(const TomlReader& reader, const table& from, LessonStep& step) {
    if (const node* at = from.get("scene")) {
        step.scene = words(reader, *at, "scene");
        step.recording = located(reader, *at, [&] { return find_run(step.scene); });
        step.recording.digest = 0;
        step.recording.step = 0;
        step.view = views().front();
        step.mode = LessonMode::SideBySide;
    } else if (step.scene.empty()) {
        reader.fail(from.source(), "the first step has no scene");
    }
    Setup& setup = step.recording.setup;
    if (const node* at = from.get("set")) {
        for (const SetParameter& s : read_settings(reader, *at)) set_parameter(setup.scene, s.key, s.value);
    }
    if (const node* at = from.get("lanes")) {
        const std::string key = words(reader, *at, "lanes");
        Lanes lanes = located(reader, *at, [&] { return find_lanes(key); });
        if (from.get("lane") != nullptr)
            reader.fail(at->source(), "lanes names a comparison, lane gives lanes: write one of them");
        setup.lanes = std::move(lanes.lanes);
        setup.reference = lanes.reference;
    }
    if (const node* at = from.get("lane")) {
        setup.lanes = read_named_lanes(reader, *at);
        setup.reference = no_reference;
    }
    if (const node* at = from.get("reference")) setup.reference = read_reference(reader, *at);
    if (const node* at = from.get("run_to")) step.recording.step = reader.integer(*at, "run_to", 0, max_run);
    located(reader, from, [&] { return lane_scenes(setup); });
}

LessonStep read_step(const TomlReader& reader, const table& from, const LessonStep* before) {
    static constexpr std::string_view known[] = {"title", "text",      "try",  "scene", "set",    "lanes",
                                                 "lane",  "reference", "view", "mode",  "run_to", "claim"};
    std::vector<TomlReader::Key> keys;
    for (const std::string_view key : known) keys.emplace_back(key, [](const node&) {});
    reader.keys(from, keys);
    LessonStep step;
    if (before != nullptr) {
        step.scene = before->scene;
        step.recording = before->recording;
        step.view = before->view;
        step.mode = before->mode;
    }
    step.title = words(reader, required(reader, from, "title", "a step"), "title");
    step.text = blocks_of(words(reader, required(reader, from, "text", "a step"), "text", true));
    if (const node* at = from.get("try")) step.tries = read_tries(reader, *at);
    read_run(reader, from, step);
    if (const node* at = from.get("view")) {
        const std::string key = reader.string(*at, "view");
        step.view = &located(reader, *at, [&]() -> const View& { return view(key); });
    }
    if (const node* at = from.get("mode")) step.mode = read_mode(reader, *at);
    if (const node* at = from.get("claim")) {
        reader.tables(*at, "claim", max_claims,
                      [&](const table& t) { step.claims.push_back(read_claim(reader, t, step)); });
    }
    return step;
}

}  // namespace

Lesson parse_lesson(std::string_view text, std::string_view name) {
    const TomlReader reader(name);
    const table root = parse_toml(text, name, max_bytes);
    const node* version = root.get("whorl");
    if (version == nullptr || version->value<int>() != lesson_version)
        reader.fail(version ? version->source() : toml::source_region{{1, 1}, {1, 1}, {}},
                    "not a lesson that this program reads: it begins with whorl = 1");
    Lesson lesson;
    lesson.key = name;
    reader.keys(root, {{"whorl", [](const node&) {}},
                       {"title", [&](const node& n) { lesson.title = words(reader, n, "title"); }},
                       {"summary", [&](const node& n) { lesson.summary = words(reader, n, "summary"); }},
                       {"step", [&](const node& n) {
                            reader.tables(n, "step", max_steps, [&](const table& t) {
                                const LessonStep* before =
                                    lesson.steps.empty() ? nullptr : &lesson.steps.back();
                                LessonStep step = read_step(reader, t, before);
                                lesson.steps.push_back(std::move(step));
                            });
                        }}});
    for (const char* key : {"title", "summary"}) required(reader, root, key, "a lesson");
    if (lesson.steps.empty()) reader.fail(root.source(), "a lesson has no steps: write [[step]]");
    return lesson;
}

}  // namespace whorl::app
