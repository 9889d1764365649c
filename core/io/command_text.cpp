#include "core/io/command_text.h"

#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/suggest.h"
#include "core/scene/parameters.h"

namespace whorl {
namespace {

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
    std::string_view rest() { return std::exchange(rest_, {}); }

    static std::string shown(std::string_view word) {
        constexpr std::size_t longest = 40;
        return std::string(word.substr(0, longest)) + (word.size() > longest ? "…" : "");
    }

  private:
    std::string_view rest_;
};

/// A scalar that is given as key=value.
FieldId find_source(const EditVerb& verb, std::string_view key) {
    std::vector<std::string_view> keys;
    std::optional<FieldId> found;
    for_sources([&](FieldId id) {
        if (has_number(verb, id)) return;
        if (id.info().key == key) found = id;
        keys.push_back(id.info().key);
    });
    if (!found && keys.empty()) throw InputError("\"" + Words::shown(key) + "\" is too much");
    if (!found)
        throw InputError("no scalar is called \"" + Words::shown(key) + "\"; " + suggestion(key, keys));
    return *found;
}

Edit read_edit(const EditVerb& verb, Words& words) {
    Edit edit{verb, {}};
    for (std::size_t k = 0; k < verb.numbers.size(); ++k) edit.numbers.push_back(words.number<double>());
    if (verb.takes_amounts) {
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            const std::size_t equals = std::min(word.find('='), word.size());
            const FieldId id = find_source(verb, word.substr(0, equals));
            edit.amounts.set(id, Words(word.substr(std::min(equals + 1, word.size()))).number<double>());
        }
    }
    if (verb.check != nullptr) verb.check(edit);
    return edit;
}

void append(std::string& line, const Edit& edit) {
    const EditVerb& verb = edit.verb.entry();
    line += verb.info.key;
    for (const double value : edit.numbers) line += ' ' + shortest(value);
    if (!verb.takes_amounts) return;
    for_sources([&](FieldId id) {
        const double amount = edit.amounts[id];
        if (amount != 0 && !has_number(verb, id))
            line += ' ' + std::string(id.info().key) + '=' + shortest(amount);
    });
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
    if (verb == "lanes") {
        const auto k = words.number<std::size_t>();
        if (k >= arrangements.size())
            throw InputError("there is no [[arrangement]] " + std::to_string(k) + " among " +
                             std::to_string(arrangements.size()));
        return arrangements[k];
    }
    if (const EditVerb* edit = EditVerb::list().seek(verb)) return read_edit(*edit, words);
    std::vector<std::string_view> verbs{"set"};
    for (const EditVerb* edit : EditVerb::list().all()) verbs.push_back(edit->info.key);
    verbs.push_back("lanes");
    throw InputError("unknown command \"" + Words::shown(verb) + "\"; " + suggestion(verb, verbs));
}

}  // namespace

std::string write_commands(std::span<const TimedCommand> commands, std::vector<Arrange>& arrangements) {
    std::string text;
    for (const auto& [step, command] : commands) {
        text += std::to_string(step) + ' ';
        if (const auto* edit = std::get_if<Edit>(&command)) {
            append(text, *edit);
        } else if (const auto* change = std::get_if<SetParameter>(&command)) {
            text += "set " + change->key + '=' + change->value;
        } else if (const auto* other = std::get_if<Arrange>(&command)) {
            text += "lanes " + std::to_string(arrangements.size());
            arrangements.push_back(*other);
        }
        text += '\n';
    }
    return text;
}

std::vector<TimedCommand> read_commands(std::string_view text, std::span<const Arrange> arrangements) {
    std::vector<TimedCommand> commands;
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
