#include "core/io/lane_table.h"

#include "core/scene/parameters.h"

namespace whorl {

std::vector<SetParameter> read_settings(const TomlReader& reader, const toml::node& node) {
    std::vector<SetParameter> settings;
    const toml::array* array = node.as_array();
    if (array == nullptr) reader.fail(node.source(), "set is a list: write [\"key=value\"]");
    for (const toml::node& item : *array) {
        const std::string assignment = reader.string(item, "an item of set");
        try {
            Scene scratch;
            set_parameter(scratch, assignment);
        } catch (const InputError& e) {
            reader.fail(item.source(), e.what());
        }
        const std::size_t equals = assignment.find('=');
        settings.push_back({assignment.substr(0, equals), assignment.substr(equals + 1)});
    }
    return settings;
}

ReadLane read_lane(const TomlReader& reader, const toml::table& table, bool arranged) {
    ReadLane lane;
    std::vector<TomlReader::Key> keys{
        {"name", [&](const toml::node& n) { lane.setup.name = reader.string(n, "name"); }},
        {"refine",
         [&](const toml::node& n) {
             lane.setup.refine = static_cast<int>(reader.integer(n, "refine", 1, 8));
         }},
        {"set", [&](const toml::node& n) {
             for (SetParameter& setting : read_settings(reader, n)) lane.setup.set(std::move(setting));
         }}};
    if (arranged) {
        keys.emplace_back("from", [&](const toml::node& n) {
            lane.from = static_cast<int>(reader.integer(n, "from", 0, Setup::max_lanes - 1));
        });
    }
    reader.keys(table, keys);
    return lane;
}

int read_reference(const TomlReader& reader, const toml::node& node) {
    return static_cast<int>(reader.integer(node, "reference", 0, Setup::max_lanes - 1));
}

std::vector<LaneSetup> read_lanes(const TomlReader& reader, const toml::node& node) {
    std::vector<LaneSetup> lanes;
    reader.tables(node, "lane", Setup::max_lanes,
                  [&](const toml::table& table) { lanes.push_back(read_lane(reader, table, false).setup); });
    return lanes;
}

}  // namespace whorl
