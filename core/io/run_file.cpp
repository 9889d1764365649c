#include "core/io/run_file.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fstream>

#include "core/io/command_text.h"
#include "core/io/lane_table.h"
#include "core/io/scene_table.h"
#include "core/scene/parameters.h"

namespace whorl {
namespace {

constexpr std::size_t max_arrangements = 1000;
constexpr const char* too_long = "too long for a run: over 16 MiB";
constexpr std::string_view keys_of_a_run[] = {"whorl",  "lane",        "reference", "step",
                                              "digest", "arrangement", "commands"};

constexpr std::size_t max_toml_bytes = std::size_t{1} << 20;  // of a run without its commands
const toml::source_region start{{1, 1}, {1, 1}, {}};

/// A run's text in two: commands, of which there may be many, and TOML, of which a parser must not see too
/// much.
struct Split {
    std::string toml;  ///< with empty lines for the commands
    std::string_view commands;
    std::size_t lines = 0;  ///< of the commands
};

/// Commands stand as write_run writes them. Elsewhere, they are a text of the TOML like others.
Split split(std::string_view text) {
    constexpr std::string_view opening = "\ncommands = \"\"\"\n", closing = "\"\"\"";
    const std::size_t key = text.find(opening);
    if (key == text.npos) return {std::string(text), {}, 0};
    const std::size_t begin = key + opening.size();
    const std::size_t end = text.find(closing, begin);
    if (end == text.npos) return {std::string(text), {}, 0};
    const std::string_view commands = text.substr(begin, end - begin);
    const auto lines = static_cast<std::size_t>(std::count(commands.begin(), commands.end(), '\n'));
    return {std::string(text.substr(0, begin)) + std::string(lines, '\n') + std::string(text.substr(end)),
            commands, lines};
}

toml::table parse_split(const Split& split, std::string_view name) {
    return parse_toml(split.toml, name, max_toml_bytes + split.lines);
}

Arrange read_arrangement(const TomlReader& reader, const toml::table& table) {
    Arrange arrange;
    reader.keys(table,
                {{"lane",
                  [&](const toml::node& n) {
                      reader.tables(n, "lane", Setup::max_lanes, [&](const toml::table& t) {
                          ReadLane lane = read_lane(reader, t, true);
                          arrange.lanes.push_back(std::move(lane.setup));
                          arrange.from.push_back(lane.from);
                      });
                  }},
                 {"reference", [&](const toml::node& n) { arrange.reference = read_reference(reader, n); }}});
    return arrange;
}

std::uint64_t read_digest(const TomlReader& reader, const toml::node& node) {
    const std::string text = reader.string(node, "digest");
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (error != std::errc{} || end != text.data() + text.size())
        reader.fail(node.source(), "digest is not 16 hexadecimal digits");
    return value;
}

void read_version(const TomlReader& reader, const toml::table& table) {
    const toml::node* version = table.get("whorl");
    if (version == nullptr) reader.fail(start, "not a Whorl scene: it begins with whorl = 1");
    if (version->value<int>() != run_version)
        reader.fail(version->source(), "this is a scene of another version; this program reads whorl = 1");
}

void read_all_commands(const TomlReader& reader, const toml::table& table, std::string_view text,
                       Recording& recording) {
    std::vector<Arrange> arrangements;
    if (const toml::node* node = table.get("arrangement")) {
        reader.tables(*node, "arrangement", max_arrangements,
                      [&](const toml::table& t) { arrangements.push_back(read_arrangement(reader, t)); });
    }
    const toml::node* commands = table.get("commands");
    if (commands == nullptr) return;
    const std::string value = reader.string(*commands, "commands");
    try {
        recording.commands = read_commands(text.empty() ? value : text, arrangements);
    } catch (const InputError& e) {
        reader.fail(commands->source(), e.what());
    }
}

void write_lane(const LaneSetup& lane, std::ostream& out) {
    out << "name = " << toml::value(lane.name) << "\nrefine = " << lane.refine << "\nset = [";
    for (const SetParameter& o : lane.overrides)
        out << (&o == &lane.overrides.front() ? "" : ", ") << toml::value(o.key + '=' + o.value);
    out << "]\n";
}

std::string shape_of(const std::string& name) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(name, error);
    if (!std::filesystem::exists(status)) return "there is no such file";
    if (std::filesystem::is_directory(status)) return "this is a folder";
    return "it cannot be read";
}

}  // namespace

Recording parse_run(std::string_view text, std::string_view name) {
    if (text.size() > max_run_bytes) fail_at(name, start.begin, too_long);
    const TomlReader reader(name);
    const Split parts = split(text);
    const toml::table table = parse_split(parts, name);
    read_version(reader, table);
    Recording recording;
    recording.setup.scene = read_scene_table(reader, table, keys_of_a_run);
    if (const toml::node* node = table.get("lane")) recording.setup.lanes = read_lanes(reader, *node);
    if (const toml::node* node = table.get("reference"))
        recording.setup.reference = read_reference(reader, *node);
    if (const toml::node* node = table.get("step"))
        recording.step = reader.integer(*node, "step", 0, Recording::max_step);
    if (const toml::node* node = table.get("digest")) recording.digest = read_digest(reader, *node);
    read_all_commands(reader, table, parts.commands, recording);
    try {
        lane_scenes(recording.setup);
    } catch (const InputError& e) {
        throw InputError(std::string(name) + ": " + e.what());
    }
    return recording;
}

std::string read_run_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(max_run_bytes + 1, '\0');
    if (!file || !file.read(text.data(), 0)) throw InputError(path.string() + ": " + shape_of(path.string()));
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (file.bad() || (text.empty() && std::filesystem::is_directory(path)))
        throw InputError(path.string() + ": " + shape_of(path.string()));
    if (text.size() > max_run_bytes) throw InputError(path.string() + ": " + too_long);
    return text;
}

std::string write_run(const Recording& recording) {
    std::vector<Arrange> arrangements;
    const std::string commands = write_commands(recording.commands, arrangements);
    std::ostringstream out;
    out << "whorl = " << run_version << "\n";
    if (recording.step > 0) out << "step = " << recording.step << "\n";
    if (recording.digest != 0) {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(recording.digest));
        out << "digest = \"" << digits << "\"\n";
    }
    if (recording.setup.reference != no_reference) out << "reference = " << recording.setup.reference << "\n";
    if (!commands.empty()) out << "commands = \"\"\"\n" << commands << "\"\"\"\n";
    write_scene_table(recording.setup.scene, out);
    if (recording.setup.lanes != std::vector{LaneSetup{}}) {
        for (const LaneSetup& lane : recording.setup.lanes) {
            out << "\n[[lane]]\n";
            write_lane(lane, out);
        }
    }
    for (const Arrange& a : arrangements) {
        out << "\n[[arrangement]]\n";
        if (a.reference != no_reference) out << "reference = " << a.reference << "\n";
        for (std::size_t k = 0; k < a.lanes.size(); ++k) {
            out << "[[arrangement.lane]]\nfrom = " << a.from[k] << "\n";
            write_lane(a.lanes[k], out);
        }
    }
    return out.str();
}

Lanes parse_lanes(std::string_view text, std::string_view name) {
    const TomlReader reader(name);
    const toml::table table = parse_split(split(text), name);
    read_version(reader, table);
    const toml::node* lanes = table.get("lane");
    if (lanes == nullptr) reader.fail(start, "there are no lanes: write [[lane]]");
    Lanes result;
    result.lanes = read_lanes(reader, *lanes);
    if (const toml::node* node = table.get("title")) result.title = reader.string(*node, "title");
    if (const toml::node* node = table.get("reference")) result.reference = read_reference(reader, *node);
    return result;
}

}  // namespace whorl
