#include "app/cli/run_tables.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace whorl::app {
namespace {

/// @param values  one or more
double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

RowNames::RowNames(const Recording& recording) : several_(recording.setup.lanes.size() > 1) {
    for (const TimedCommand& timed : recording.commands) {
        const auto* arrange = std::get_if<Arrange>(&timed.command);
        several_ = several_ || (arrange != nullptr && arrange->lanes.size() > 1);
    }
}

const std::string& RowNames::of(const Session& session, std::size_t k) {
    const auto [lane, is_new] = names_.try_emplace(session.id(k));
    if (is_new) lane->second = unused(titles(session.setup())[k]);
    return lane->second;
}

std::string RowNames::unused(const std::string& title) const {
    const auto used = [&](const std::string& name) {
        return std::any_of(names_.begin(), names_.end(), [&](const auto& n) { return n.second == name; });
    };
    std::string name = title;
    for (int n = 2; used(name); ++n) name = title + " (" + std::to_string(n) + ")";
    return name;
}

Rows::Rows(const std::string& file, RowNames& names, Columns columns)
    : names_(names),
      columns_(std::move(columns)),
      series_(file, (names.several() ? "lane," : "") + columns_.header()) {}

void Rows::add(const Session& session) {
    for (std::size_t k = 0; k < session.lane_count(); ++k) {
        const std::vector<double>& row = columns_.row(session.step_number(), session.measures(k));
        if (names_.several()) {
            series_.row({names_.of(session, k)}, row);
        } else {
            series_.row(row);
        }
    }
}

void Timings::add(const Session& session) {
    for (std::size_t k = 0; k < session.lane_count(); ++k) {
        Lane& lane = lanes_[session.id(k)];
        if (lane.values.empty()) lane.name = names_.of(session, k);
        lane.values.resize(columns_.all().size());
        for (std::size_t c = 0; c < lane.values.size(); ++c)
            lane.values[c].push_back(columns_.all()[c]->of(session.measures(k)));
    }
}

void Timings::write(const std::string& file) const {
    Series series(file, names_.several() ? "lane,phase,median_ms" : "phase,median_ms");
    for (const auto& entry : lanes_) {
        const Lane& lane = entry.second;
        for (std::size_t c = 0; c < lane.values.size(); ++c) {
            const double value = median(lane.values[c]);
            const std::string& phase = columns_.all()[c]->label();
            if (names_.several()) {
                series.row({lane.name, phase}, {&value, 1});
            } else {
                series.row({phase}, {&value, 1});
            }
        }
    }
    series.finish();
}

}  // namespace whorl::app
