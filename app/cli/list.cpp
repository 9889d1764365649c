// `whorl list`: what there is to choose from, from the scheme lists and the parameter table.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <vector>

#include "app/cli/verbs.h"
#include "app/render/colour_map.h"
#include "app/scenes/comparisons.h"
#include "app/scenes/presets.h"
#include "app/views/views.h"
#include "core/base/error.h"
#include "core/base/suggest.h"
#include "core/experiments/experiment.h"
#include "core/measure/measure.h"
#include "core/scene/parameters.h"
#include "core/sources/edit.h"

namespace whorl::app {
namespace {

using Row = std::vector<std::string>;

/// Rows in columns as wide as they need to be. UTF-8 counts by letters.
void print(const std::vector<Row>& rows) {
    const auto letters = [](const std::string& s) {
        return std::count_if(s.begin(), s.end(),
                             [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    };
    std::vector<std::ptrdiff_t> widths;
    for (const Row& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], letters(row[k]));
    }
    for (const Row& row : rows) {
        std::string line = " ";
        for (std::size_t k = 0; k < row.size(); ++k) {
            line +=
                ' ' + row[k] + std::string(static_cast<std::size_t>(widths[k] - letters(row[k])) + 1, ' ');
        }
        line.erase(line.find_last_not_of(' ') + 1);
        std::puts(line.c_str());
    }
}

std::vector<Row> scheme_rows(std::span<const SchemeInfo> infos) {
    std::vector<Row> rows;
    for (const SchemeInfo& i : infos) {
        rows.push_back(
            {std::string(i.key), std::string(i.label), std::string(i.help), std::string(i.source)});
    }
    return rows;
}

/// Whether it sets the schemes of the velocity or of the scalars alone.
bool of_one_set(const Parameter& p) {
    return p.key.starts_with("velocity.") || p.key.starts_with("scalars.");
}

/// The list of a parameter's choices.
std::string plural(const std::string& key) {
    return key.ends_with('s') ? key : key + "s";
}

std::vector<Row> preset_rows() {
    std::vector<Row> rows;
    for (const Preset& p : presets()) rows.push_back({std::string(p.key), p.scene().title});
    return rows;
}

std::vector<Row> comparison_rows() {
    std::vector<Row> rows;
    for (const Comparison& c : comparisons()) {
        const Lanes lanes = c.lanes();
        std::string names;
        for (const LaneSetup& lane : lanes.lanes) names += (names.empty() ? "" : ", ") + lane.name;
        rows.push_back({std::string(c.key), lanes.title, names});
    }
    return rows;
}

std::vector<Row> experiment_rows() {
    std::vector<Row> rows;
    for (const Experiment& e : experiments()) {
        if (e.listed)
            rows.push_back({std::string(e.info.key), std::string(e.info.help), std::string(e.info.source)});
    }
    return rows;
}

std::vector<Row> field_rows() {
    std::vector<Row> rows{{"key", "unit", "meaning", "moves by the schemes of"}};
    for (const FieldInfo& f : fields()) {
        const char* const by = f.advected_by == AdvectedBy::Velocity  ? "the velocity"
                               : f.advected_by == AdvectedBy::Scalars ? "the scalars"
                                                                      : "–";
        rows.push_back(
            {std::string(f.key), f.unit.empty() ? "–" : std::string(f.unit), std::string(f.title), by});
    }
    return rows;
}

std::vector<Row> view_rows() {
    std::vector<Row> rows;
    for (const View* view : views())
        rows.push_back({std::string(view->key), std::string(view->label), std::string(view->help)});
    return rows;
}

std::vector<Row> map_rows() {
    std::vector<Row> rows;
    for (const ColourMap& m : colour_maps()) rows.push_back({std::string(m.key), std::string(m.label)});
    return rows;
}

std::vector<Row> measure_rows() {
    std::vector<Row> rows{{"key", "unit", "meaning", "source"}};
    for (const Measure* m : measures().all())
        rows.push_back({m->key, m->unit.empty() ? "–" : m->unit, m->help, m->source});
    return rows;
}

std::vector<Row> edit_rows() {
    std::vector<Row> rows{{"verb", "numbers", "meaning"}};
    for (const EditVerb* verb : EditVerb::list().all()) {
        std::string numbers;
        for (const std::string_view number : verb->numbers)
            numbers += (numbers.empty() ? "" : " ") + std::string(number);
        rows.push_back({std::string(verb->info.key), numbers, std::string(verb->info.help)});
    }
    return rows;
}

std::vector<Row> parameter_rows() {
    std::vector<Row> rows{{"key", "default", "range", "unit", "meaning"}};
    for (const Parameter& p : parameters()) {
        if (of_one_set(p)) continue;
        std::string range;
        if (p.kind == Parameter::Kind::Choice) {
            for (const SchemeInfo& choice : p.choices)
                range += (range.empty() ? "" : " ") + std::string(choice.key);
            if (range.size() > 44) range = "see whorl list " + plural(p.key);
        } else {
            range = p.kind == Parameter::Kind::Switch ? "true false" : p.text(p.min) + " … " + p.text(p.max);
        }
        rows.push_back({p.key, p.text(p.default_value()), range, p.unit.empty() ? "–" : p.unit, p.help});
    }
    return rows;
}

struct Listing {
    std::string name;
    std::function<std::vector<Row>()> rows;
};

std::vector<Listing> listings() {
    std::vector<Listing> all{
        {"presets", preset_rows}, {"comparisons", comparison_rows}, {"experiments", experiment_rows}};
    for (const Parameter& p : parameters()) {
        if (p.kind == Parameter::Kind::Choice && !of_one_set(p))
            all.push_back({plural(p.key), [&p] { return scheme_rows(p.choices); }});
    }
    all.insert(all.end(), {{"fields", field_rows},
                           {"views", view_rows},
                           {"maps", map_rows},
                           {"measures", measure_rows},
                           {"edits", edit_rows},
                           {"parameters", parameter_rows}});
    return all;
}

}  // namespace

int run_list(const ListArguments& arguments) {
    const std::vector<Listing> all = listings();
    if (!arguments.what.empty()) {
        std::vector<std::string_view> names;
        for (const Listing& listing : all) {
            if (listing.name == arguments.what) {
                print(listing.rows());
                return 0;
            }
            names.push_back(listing.name);
        }
        throw InputError("nothing is called \"" + arguments.what + "\"; " +
                         suggestion(arguments.what, names));
    }
    for (const Listing& listing : all) {
        std::printf("%s%s\n", &listing == all.data() ? "" : "\n", listing.name.c_str());
        print(listing.rows());
    }
    std::puts("\nA scheme's key also takes the prefix velocity. or scalars. to set one of the two alone.");
    return 0;
}

}  // namespace whorl::app
