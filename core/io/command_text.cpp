#include "core/io/command_text.h"

#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/suggest.h"
#include "core/scene/parameters.h"

namespace whorl {
namespace {

constexpr std::string_view verbs[] = {"set", "smoke", "push", "build", "erase", "lanes"};

void append(std::string& line, double value) {
    line += ' ' + shortest(value);
}

/// The amount of a scalar beside smoke and heat, which have places of their own.
void append(std::string& line, FieldId id, double amount) {
    if (id == field::density || id == field::temperature || amount == 0) return;
    line += ' ' + std::string(id.info().key) + '=' + shortest(amount);
}

void append(std::string& line, const Segment& s) {
    for (const double value : {s.x0, s.y0, s.x1, s.y1}) append(line, value);
}

/// Takes one word after the other off a line.
class Words {
  public:
    explicit Words(std::string_view line) : rest_(line) {}

    std::string_view next() {
        const std::size_t space = rest_.find(' ');
        const std::string_view word = rest_.substr(0, space);
        rest_.remove_prefix(space == std::string_view::npos ? rest_.size() : space + 1);
        return word;
    }
    template <class Number>
    Number number() {
        const std::string_view word = next();
        if (word.empty()) throw InputError("a number is missing");
        Number value{};
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size())
            throw InputError("\"" + shown(word) + "\" is not a number");
        if constexpr (std::is_floating_point_v<Number>) {
            if (!std::isfinite(value)) throw InputError("\"" + shown(word) + "\" is not finite");
        }
        return value;
    }
    Segment segment() {
        Segment s;
        for (double* value : {&s.x0, &s.y0, &s.x1, &s.y1}) *value = number<double>();
        return s;
    }
    double radius() {
        const Parameter& p = parameter("brush.radius");
        const double value = number<double>();
        p.check(value);
        return value;
    }
    std::string_view rest() { return std::exchange(rest_, {}); }

    static std::string shown(std::string_view word) {
        constexpr std::size_t longest = 40;
        return std::string(word.substr(0, longest)) + (word.size() > longest ? "…" : "");
    }

  private:
    std::string_view rest_;
};

/// A scalar that is given as key=value.
FieldId find_source(std::string_view key) {
    std::vector<std::string_view> keys;
    std::optional<FieldId> found;
    for_sources([&](FieldId id) {
        if (id == field::density || id == field::temperature) return;
        if (id.info().key == key) found = id;
        keys.push_back(id.info().key);
    });
    if (!found && keys.empty()) throw InputError("\"" + Words::shown(key) + "\" is too much");
    if (!found)
        throw InputError("no scalar is called \"" + Words::shown(key) + "\"; " + suggestion(key, keys));
    return *found;
}

SmokeStroke read_smoke(Words& words, bool smoke) {
    SmokeStroke s{.along = words.segment(), .radius = words.radius(), .smoke = smoke};
    for (double* value : {&s.amounts.at(field::density), &s.amounts.at(field::temperature), &s.push,
                          &s.velocity_x, &s.velocity_y})
        *value = words.number<double>();
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        const std::size_t equals = std::min(word.find('='), word.size());
        const FieldId id = find_source(word.substr(0, equals));
        s.amounts.set(id, Words(word.substr(std::min(equals + 1, word.size()))).number<double>());
    }
    return s;
}

ObstacleStroke read_obstacle(Words& words, bool solid) {
    const Segment along = words.segment();
    return {along, words.radius(), solid};
}

Command read_command(Words& words, std::span<const Arrange> arrangements) {
    const std::string_view verb = words.next();
    if (verb == "set") {
        const std::string_view assignment = words.rest();
        Scene scratch;
        set_parameter(scratch, assignment);
        const std::size_t equals = assignment.find('=');
        return SetParameter{std::string(assignment.substr(0, equals)),
                            std::string(assignment.substr(equals + 1))};
    }
    if (verb == "smoke" || verb == "push") return read_smoke(words, verb == "smoke");
    if (verb == "build" || verb == "erase") return read_obstacle(words, verb == "build");
    if (verb == "lanes") {
        const auto k = words.number<std::size_t>();
        if (k >= arrangements.size())
            throw InputError("there is no [[arrangement]] " + std::to_string(k) + " among " +
                             std::to_string(arrangements.size()));
        return arrangements[k];
    }
    throw InputError("unknown command \"" + Words::shown(verb) + "\"; " +
                     suggestion(verb, {std::begin(verbs), std::end(verbs)}));
}

}  // namespace

std::string write_commands(std::span<const Stamped> commands, std::vector<Arrange>& arrangements) {
    std::string text;
    for (const auto& [step, command] : commands) {
        text += std::to_string(step) + ' ';
        std::visit(
            [&]<class C>(const C& c) {
                if constexpr (std::is_same_v<C, SetParameter>) {
                    text += "set " + c.key + '=' + c.value;
                } else if constexpr (std::is_same_v<C, SmokeStroke>) {
                    text += c.smoke ? "smoke" : "push";
                    append(text, c.along);
                    for (const double value :
                         {c.radius, c.amounts[field::density], c.amounts[field::temperature], c.push,
                          c.velocity_x, c.velocity_y})
                        append(text, value);
                    for_sources([&](FieldId id) { append(text, id, c.amounts[id]); });
                } else if constexpr (std::is_same_v<C, ObstacleStroke>) {
                    text += c.solid ? "build" : "erase";
                    append(text, c.along);
                    append(text, c.radius);
                } else if constexpr (std::is_same_v<C, Arrange>) {
                    text += "lanes " + std::to_string(arrangements.size());
                    arrangements.push_back(c);
                }
            },
            command);
        text += '\n';
    }
    return text;
}

std::vector<Stamped> read_commands(std::string_view text, std::span<const Arrange> arrangements) {
    std::vector<Stamped> commands;
    for (std::size_t line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view row = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (row.empty()) continue;
        try {
            if (commands.size() == Recording::max_commands)
                throw InputError("there are at most " + std::to_string(Recording::max_commands) +
                                 " commands in a run");
            Words words(row);
            const long step = words.number<long>();
            const long earliest = commands.empty() ? 0 : commands.back().step;
            if (step < earliest || step > Recording::max_step)
                throw InputError("step " + std::to_string(step) + " is out of order: " +
                                 std::to_string(earliest) + " to " + std::to_string(Recording::max_step));
            commands.push_back({step, read_command(words, arrangements)});
            if (const std::string_view rest = words.rest(); !rest.empty())
                throw InputError("\"" + Words::shown(rest) + "\" is too much");
        } catch (const InputError& e) {
            throw InputError("command " + std::to_string(line) + ": " + e.what());
        }
    }
    return commands;
}

}  // namespace whorl
