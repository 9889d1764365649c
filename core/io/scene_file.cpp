#include "core/io/scene_file.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "core/experiments/experiment.h"
#include "core/io/toml_text.h"
#include "core/scene/error.h"
#include "core/scene/parameters.h"
#include "core/schemes/suggest.h"

namespace whorl {
namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 20;
constexpr std::size_t max_tables = 1000;  // emitters, and obstacles
/// Lengths and what an emitter holds, either sign: far beyond any domain, and few enough cells to count.
constexpr double max_number = 1e5;

/// Says where in a text something is wrong.
class Reader {
  public:
    explicit Reader(std::string_view name) : name_(name) {}

    [[noreturn]] void fail(const toml::source_region& at, const std::string& reason) const {
        fail_at(name_, at.begin, reason);
    }

    /// The node's value as `--set` would be given it.
    std::string text(const toml::node& node) const {
        if (const auto* value = node.as_string()) return value->get();
        if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
        if (const auto* value = node.as_integer()) return std::to_string(value->get());
        if (const auto* value = node.as_floating_point()) {
            std::ostringstream out;
            out.precision(17);
            out << value->get();
            return out.str();
        }
        fail(node.source(), "expected a number, a truth or a word");
    }

    double number(const toml::node& node, const std::string& key, double most) const {
        const auto value = node.value<double>();
        if (!value || *value != *value) fail(node.source(), key + " is not a number");
        if (std::abs(*value) > most) fail(node.source(), key + " is out of range: -100000 to 100000");
        return *value;
    }

  private:
    std::string_view name_;
};

struct NumberKey {
    std::string_view key;
    double* value;
    double most = max_number;
};

/// Fills numbers from a table, and knows no other keys.
void read_numbers(const Reader& reader, const toml::table& table, std::initializer_list<NumberKey> known) {
    for (const auto& [key, node] : table) {
        bool found = false;
        std::vector<std::string_view> keys;
        for (const NumberKey& k : known) {
            keys.push_back(k.key);
            if (k.key != key.str()) continue;
            *k.value = reader.number(node, std::string(key.str()), k.most);
            found = true;
        }
        if (!found)
            reader.fail(key.source(),
                        "unknown key \"" + std::string(key.str()) + "\"; " + suggestion(key.str(), keys));
    }
}

/// Calls `read(table)` for each table of an array of tables.
template <class Read>
void for_tables(const Reader& reader, const toml::node& node, const char* what, Read&& read) {
    const toml::array* array = node.as_array();
    if (array == nullptr)
        reader.fail(node.source(), std::string(what) + " is a list: write [[" + what + "]]");
    if (array->size() > max_tables) reader.fail(node.source(), std::string("too many tables of ") + what);
    for (const toml::node& item : *array) {
        const toml::table* table = item.as_table();
        if (table == nullptr)
            reader.fail(item.source(), std::string(what) + " holds tables: write [[" + what + "]]");
        read(*table);
    }
}

void read_emitter(const Reader& reader, const toml::table& table, Scene& scene) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();  // "never" is a time
    Emitter e;
    read_numbers(reader, table,
                 {{"x", &e.x},
                  {"y", &e.y},
                  {"width", &e.width},
                  {"height", &e.height},
                  {"density", &e.density},
                  {"temperature", &e.temperature},
                  {"from", &e.from, unlimited},
                  {"until", &e.until, unlimited}});
    if (e.width <= 0 || e.height <= 0)
        reader.fail(table.source(), "an emitter's width and height are more than 0");
    scene.emitters.push_back(e);
}

void read_obstacle(const Reader& reader, const toml::table& table, Scene& scene) {
    Obstacle o;
    read_numbers(
        reader, table,
        {{"x", &o.x}, {"y", &o.y}, {"radius", &o.radius}, {"width", &o.width}, {"height", &o.height}});
    const bool disc = o.radius > 0 && o.width == 0 && o.height == 0;
    const bool rectangle = o.radius == 0 && o.width > 0 && o.height > 0;
    if (!disc && !rectangle)
        reader.fail(table.source(), "an obstacle has a radius, or a width and a height, more than 0");
    scene.obstacles.push_back(o);
}

/// Parameters, those of dotted keys too (`velocity.advector`).
void read_parameters(const Reader& reader, const toml::table& table, const std::string& prefix,
                     Scene& scene) {
    for (const auto& [key, node] : table) {
        const std::string name = prefix + std::string(key.str());
        if (prefix.empty() && (name == "whorl" || name == "title" || name == "experiment" ||
                               name == "dimensions" || name == "emitter" || name == "obstacle")) {
            continue;
        }
        if (const toml::table* inner = node.as_table(); inner != nullptr && prefix.empty()) {
            read_parameters(reader, *inner, name + ".", scene);
            continue;
        }
        try {
            set_parameter(scene, name, reader.text(node));
        } catch (const InputError& e) {
            const std::string reason = e.what();
            reader.fail(reason.starts_with("unknown parameter") ? key.source() : node.source(), reason);
        }
    }
}

}  // namespace

Scene parse_scene(std::string_view text, std::string_view name) {
    const Reader reader(name);
    const toml::table table = parse_toml(text, name, max_bytes);
    const toml::node* version = table.get("whorl");
    if (version == nullptr) reader.fail({{1, 1}, {1, 1}, {}}, "not a Whorl scene: it begins with whorl = 1");
    if (version->value<int>() != scene_version) {
        reader.fail(version->source(), "this is a scene of another version; this program reads whorl = 1");
    }
    Scene scene;
    const toml::node* start = table.get("experiment");
    try {
        scene = scene_of(experiment(start ? start->value_or<std::string>("") : "empty"));
    } catch (const InputError& e) {
        reader.fail(start->source(), e.what());
    }
    if (const toml::node* title = table.get("title")) scene.title = title->value_or<std::string>("");
    if (const toml::node* node = table.get("emitter")) {
        scene.emitters.clear();
        for_tables(reader, *node, "emitter", [&](const toml::table& t) { read_emitter(reader, t, scene); });
    }
    if (const toml::node* node = table.get("obstacle")) {
        scene.obstacles.clear();
        for_tables(reader, *node, "obstacle", [&](const toml::table& t) { read_obstacle(reader, t, scene); });
    }
    read_parameters(reader, table, "", scene);
    const std::string reason = conflict(scene);
    if (!reason.empty()) throw InputError(std::string(name) + ": " + reason);
    return scene;
}

Scene read_scene(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(max_bytes + 1, '\0');  // a device may have no end
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!file.is_open() || file.bad()) throw InputError(path.string() + ": cannot be read as a scene");
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > max_bytes) throw InputError(path.string() + ": too large for a scene (over 1 MiB)");
    return parse_scene(text, path.string());
}

std::string write_scene(const Scene& scene) {
    toml::table table;
    std::ostringstream out;
    out << "whorl = " << scene_version << "\ntitle = " << toml::value(scene.title)
        << "\nexperiment = " << toml::value(scene.experiment) << "\n\n";
    const bool one_set = scene.velocity == scene.scalars;
    for (const Parameter& p : parameters()) {
        const bool of_one = p.key.starts_with("velocity.") || p.key.starts_with("scalars.");
        const bool has_both = std::any_of(parameters().begin(), parameters().end(),
                                          [&](const Parameter& q) { return q.key == "velocity." + p.key; });
        if ((of_one && one_set) || (has_both && !one_set)) continue;
        const std::string value = p.text(p.get(scene));
        out << p.key << " = ";
        if (p.kind == Parameter::Kind::Choice) {
            out << '"' << value << '"';
        } else {
            out << value;
        }
        out << '\n';
    }
    if (scene.emitters.empty()) out << "emitter = []\n";
    if (scene.obstacles.empty()) out << "obstacle = []\n";
    out.precision(17);
    for (const Emitter& e : scene.emitters) {
        out << "\n[[emitter]]\nx = " << e.x << "\ny = " << e.y << "\nwidth = " << e.width
            << "\nheight = " << e.height << "\ndensity = " << e.density << "\ntemperature = " << e.temperature
            << "\nfrom = " << e.from << "\nuntil = " << e.until << "\n";
    }
    for (const Obstacle& o : scene.obstacles) {
        out << "\n[[obstacle]]\nx = " << o.x << "\ny = " << o.y << "\n";
        if (o.radius > 0) {
            out << "radius = " << o.radius << "\n";
        } else {
            out << "width = " << o.width << "\nheight = " << o.height << "\n";
        }
    }
    return out.str();
}

}  // namespace whorl
