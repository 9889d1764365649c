// Reading TOML tables with errors that say where.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/suggest.h"
#include "core/io/toml_text.h"

namespace whorl {

/// Says where in a text something is wrong.
class TomlReader {
  public:
    /// @param name  what errors call the text
    explicit TomlReader(std::string_view name) : name_(name) {}

    [[noreturn]] void fail(const toml::source_region& at, const std::string& reason) const {
        fail_at(name_, at.begin, reason);
    }

    /// The node's value as `--set` would be given it; of what cannot be given so, something that is refused.
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
        return node.is_array() ? "[…]" : "…";
    }

    /// Lengths and the like, either sign, lie far within this: it is beyond any domain.
    static constexpr double max_number = 1e5;
    double number(const toml::node& node, const std::string& key, double most = max_number) const {
        const auto value = node.value<double>();
        if (!value || *value != *value) fail(node.source(), key + " is not a number");
        if (std::abs(*value) > most) fail(node.source(), key + " is out of range: -100000 to 100000");
        return *value;
    }
    long integer(const toml::node& node, const std::string& key, long min, long max) const {
        const auto value = node.value<std::int64_t>();
        if (!value || !node.is_integer() || *value < min || *value > max)
            fail(node.source(),
                 key + " is not a whole number from " + std::to_string(min) + " to " + std::to_string(max));
        return static_cast<long>(*value);
    }
    std::string string(const toml::node& node, const std::string& key) const {
        const auto* value = node.as_string();
        if (value == nullptr) fail(node.source(), key + " is not a text: write it in quotes");
        return value->get();
    }

    /// What to do with a key's value.
    using Key = std::pair<std::string_view, std::function<void(const toml::node&)>>;
    /// Hands each value of a table to its key, and knows no other keys.
    void keys(const toml::table& table, const std::vector<Key>& known) const {
        for (auto&& [key, node] : table) {
            const std::string_view name = key.str();
            const Key* found = nullptr;
            std::vector<std::string_view> names;
            for (const Key& k : known) {
                if (k.first == name) found = &k;
                names.push_back(k.first);
            }
            if (found == nullptr)
                fail(key.source(), "unknown key \"" + std::string(name) + "\"; " + suggestion(name, names));
            found->second(node);
        }
    }

    /// Calls `read(table)` for each table of an array of tables, of at most `max`.
    template <class Read>
    void tables(const toml::node& node, const std::string& what, std::size_t max, Read&& read) const {
        const toml::array* array = node.as_array();
        if (array == nullptr) fail(node.source(), what + " is a list: write [[" + what + "]]");
        if (array->size() > max)
            fail(node.source(), std::to_string(array->size()) + " tables of " + what +
                                    ": there are at most " + std::to_string(max));
        for (const toml::node& item : *array) {
            const toml::table* table = item.as_table();
            if (table == nullptr) fail(item.source(), what + " holds tables: write [[" + what + "]]");
            read(*table);
        }
    }

  private:
    std::string_view name_;
};

}  // namespace whorl
