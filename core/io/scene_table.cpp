#include "core/io/scene_table.h"

#include <algorithm>
#include <limits>
#include <ostream>

#include "core/experiments/experiment.h"
#include "core/scene/parameters.h"

namespace whorl {
namespace {

constexpr std::size_t max_tables = 1000;  // emitters, and obstacles

constexpr double unlimited = std::numeric_limits<double>::infinity();  // "never" is a time

TomlReader::Key number(const TomlReader& reader, std::string_view key, double& value,
                       double most = TomlReader::max_number) {
    return {key, [&reader, key, &value, most](const toml::node& node) {
                value = reader.number(node, std::string(key), most);
            }};
}

Emitter read_emitter(const TomlReader& reader, const toml::table& table) {
    Emitter e;
    std::vector<TomlReader::Key> keys{number(reader, "x", e.x),
                                      number(reader, "y", e.y),
                                      number(reader, "width", e.width),
                                      number(reader, "height", e.height),
                                      number(reader, "from", e.from, unlimited),
                                      number(reader, "until", e.until, unlimited)};
    for_sources([&](FieldId id) { keys.push_back(number(reader, id.info().key, e.amounts.at(id))); });
    reader.keys(table, keys);
    if (e.width <= 0 || e.height <= 0)
        reader.fail(table.source(), "an emitter's width and height are more than 0");
    return e;
}

Obstacle read_obstacle(const TomlReader& reader, const toml::table& table) {
    Obstacle o;
    reader.keys(table,
                {number(reader, "x", o.x), number(reader, "y", o.y), number(reader, "radius", o.radius),
                 number(reader, "width", o.width), number(reader, "height", o.height)});
    const bool disc = o.radius > 0 && o.width == 0 && o.height == 0;
    const bool rectangle = o.radius == 0 && o.width > 0 && o.height > 0;
    if (!disc && !rectangle)
        reader.fail(table.source(), "an obstacle has a radius, or a width and a height, more than 0");
    return o;
}

/// Parameters, those of dotted keys too (`velocity.advector`).
void read_parameters(const TomlReader& reader, const toml::table& table, const std::string& prefix,
                     std::span<const std::string_view> others, Scene& scene) {
    for (const auto& [key, node] : table) {
        const std::string name = prefix + std::string(key.str());
        if (prefix.empty() && std::find(others.begin(), others.end(), name) != others.end()) continue;
        if (const toml::table* inner = node.as_table(); inner != nullptr && prefix.empty()) {
            read_parameters(reader, *inner, name + ".", others, scene);
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

Scene read_scene_table(const TomlReader& reader, const toml::table& table,
                       std::span<const std::string_view> others) {
    Scene scene;
    const toml::node* start = table.get("experiment");
    try {
        scene = scene_of(experiment(start ? start->value_or<std::string>("") : "empty"));
    } catch (const InputError& e) {
        reader.fail(start->source(), e.what());
    }
    if (const toml::node* title = table.get("title")) scene.title = reader.string(*title, "title");
    if (const toml::node* node = table.get("emitter")) {
        scene.emitters.clear();
        reader.tables(*node, "emitter", max_tables,
                      [&](const toml::table& t) { scene.emitters.push_back(read_emitter(reader, t)); });
    }
    if (const toml::node* node = table.get("obstacle")) {
        scene.obstacles.clear();
        reader.tables(*node, "obstacle", max_tables,
                      [&](const toml::table& t) { scene.obstacles.push_back(read_obstacle(reader, t)); });
    }
    static constexpr std::string_view own[] = {"title", "experiment", "dimensions", "emitter", "obstacle"};
    std::vector<std::string_view> skipped(others.begin(), others.end());
    skipped.insert(skipped.end(), std::begin(own), std::end(own));
    read_parameters(reader, table, "", skipped, scene);
    return scene;
}

void write_scene_table(const Scene& scene, std::ostream& out) {
    out << "title = " << toml::value(scene.title) << "\nexperiment = " << toml::value(scene.experiment)
        << "\n\n";
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
            << "\nheight = " << e.height;
        for_sources([&](FieldId id) { out << '\n' << id.info().key << " = " << e.amounts[id]; });
        out << "\nfrom = " << e.from << "\nuntil = " << e.until << "\n";
    }
    for (const Obstacle& o : scene.obstacles) {
        out << "\n[[obstacle]]\nx = " << o.x << "\ny = " << o.y << "\n";
        if (o.radius > 0) {
            out << "radius = " << o.radius << "\n";
        } else {
            out << "width = " << o.width << "\nheight = " << o.height << "\n";
        }
    }
}

}  // namespace whorl
