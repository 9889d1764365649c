// See refusals.h.
#include "app/cli/refusals.h"

#include <algorithm>
#include <iostream>
#include <vector>

#include "app/cli/exit_code.h"
#include "core/base/suggest.h"

namespace whorl::app {
namespace {

/// The verb that was asked for; the window's own arguments stand under `app` itself.
const CLI::App& verb_of(const CLI::App& app) {
    const std::vector<const CLI::App*> verbs = app.get_subcommands({});
    const auto asked =
        std::find_if(verbs.begin(), verbs.end(), [](const CLI::App* v) { return v->parsed(); });
    return asked == verbs.end() ? app : **asked;
}

std::string stands_before(const std::string& option, const CLI::App& verb) {
    return option + " stands before " + verb.get_name() + "; give what " + verb.get_name() +
           " takes behind it";
}

/// A word that nothing takes, most likely because the one before it is meant to be a verb.
std::string too_many(const CLI::App& app, const std::string& word) {
    const CLI::App& verb = verb_of(app);
    std::vector<std::string> names;
    for (const CLI::App* v : app.get_subcommands({})) names.push_back(v->get_name());
    const std::vector<std::string_view> verbs(names.begin(), names.end());
    const auto first = app.get_option("scene")->results();
    if (&verb == &app && !first.empty()) {
        const std::string meant = suggestion(first.front(), verbs);
        if (meant.starts_with("did you mean")) return "unknown verb \"" + first.front() + "\"; " + meant;
    }
    return "\"" + word + "\" is one argument too many";
}

}  // namespace

std::string unexpected(const CLI::App& app) {
    const std::vector<std::string> left = app.remaining(true);
    const auto option =
        std::find_if(left.begin(), left.end(), [](const std::string& a) { return a[0] == '-'; });
    if (option == left.end()) return too_many(app, left.front());
    const CLI::App& verb = verb_of(app);
    if (&verb != &app && !app.remaining().empty()) return stands_before(*option, verb);
    std::vector<std::string> names;
    for (const CLI::Option* o : verb.get_options(
             [](const CLI::Option* o) { return !o->get_positional() && !o->get_group().empty(); })) {
        names.push_back(o->get_name());
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string name = option->substr(0, option->find('='));
    return "unknown option " + name + "; " + suggestion(name, known);
}

std::optional<std::string> misplaced(const CLI::App& app) {
    const CLI::App& verb = verb_of(app);
    if (&verb == &app) return {};
    const auto given = app.get_options([](const CLI::Option* o) { return o->count() > 0; });
    if (given.empty()) return {};
    return stands_before(given.front()->get_name(), verb);
}

std::string mismatch(const std::string& said) {
    const bool missing = said.find("missing") != std::string::npos;
    return said.substr(0, said.find(':')) + (missing ? " lacks its value" : " is given more than once");
}

int refuse(const CLI::App& app, std::string reason) {
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    const CLI::App& verb = verb_of(app);
    std::cerr << "whorl: " << reason << "; see whorl " << (&verb == &app ? "" : verb.get_name() + " ")
              << "--help\n";
    return exit_bad_input;
}

}  // namespace whorl::app
