#include "core/session/setup.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/scene/parameters.h"

namespace whorl {
namespace {

std::string called(const LaneSetup& lane) {
    return lane.name.empty() ? "a lane" : "lane \"" + lane.name + "\"";
}

/// A value in the words of the screen: "MacCormack", "ζ = 2", "Clamp interpolation: off".
std::string words(const Parameter& p, double value) {
    if (p.kind == Parameter::Kind::Choice) {
        const SchemeInfo& choice = p.choices[static_cast<std::size_t>(value)];
        return std::string(choice.label);
    }
    if (p.kind == Parameter::Kind::Switch) return p.label + (value != 0 ? ": on" : ": off");
    return p.label + " = " + significant(value, 4);
}

bool of_one_set(const Parameter& p) {
    return p.key.starts_with("velocity.") || p.key.starts_with("scalars.");
}

/// Whether a parameter says something that others of the table do not say already.
bool tells(const Parameter& p, const std::vector<Scene>& scenes) {
    const bool apart =
        std::any_of(scenes.begin(), scenes.end(), [](const Scene& s) { return !(s.velocity == s.scalars); });
    if (p.key == "linked") return false;
    if (of_one_set(p)) return apart;
    const bool of_both = std::any_of(parameters().begin(), parameters().end(),
                                     [&](const Parameter& q) { return q.key == "velocity." + p.key; });
    return !(of_both && apart);
}

}  // namespace

void LaneSetup::set(SetParameter override) {
    const auto same = std::find_if(overrides.begin(), overrides.end(),
                                   [&](const SetParameter& o) { return o.key == override.key; });
    if (same != overrides.end()) {
        same->value = std::move(override.value);
    } else {
        overrides.push_back(std::move(override));
    }
}

Scene lane_scene(const Scene& scene, const LaneSetup& lane) {
    try {
        Scene result = scene;
        for (const SetParameter& o : lane.overrides) set_parameter(result, o.key, o.value);
        if (lane.refine != 1) {
            const auto& known = Setup::refinements;
            if (std::find(std::begin(known), std::end(known), lane.refine) == std::end(known))
                throw InputError("refine = " + std::to_string(lane.refine) + " is not one of 1, 2, 4, 8");
            result.resolution *= lane.refine;
            result.dt /= lane.refine;
            const Parameter& resolution = parameter("resolution");
            if (result.resolution > resolution.max)
                throw InputError(std::to_string(lane.refine) + " times the resolution is " +
                                 std::to_string(result.resolution) + " cells, more than " +
                                 resolution.text(resolution.max));
        }
        const std::string reason = conflict(result);
        if (!reason.empty()) throw InputError(reason);
        return result;
    } catch (const InputError& e) {
        if (lane == LaneSetup{}) throw;
        throw InputError(called(lane) + ": " + e.what());
    }
}

std::vector<Scene> lane_scenes(const Setup& setup) {
    if (setup.lanes.empty() || setup.lanes.size() > Setup::max_lanes)
        throw InputError(std::to_string(setup.lanes.size()) + " lanes: there are 1 to " +
                         std::to_string(Setup::max_lanes));
    if (setup.reference < no_reference || setup.reference >= static_cast<int>(setup.lanes.size()))
        throw InputError("the reference is none of the lanes");
    std::vector<Scene> scenes;
    for (const LaneSetup& lane : setup.lanes) scenes.push_back(lane_scene(setup.scene, lane));
    return scenes;
}

std::vector<std::string> differences(const std::vector<Scene>& scenes) {
    std::vector<std::string> texts(scenes.size());
    for (const Parameter& p : parameters()) {
        const bool agree = std::all_of(scenes.begin(), scenes.end(),
                                       [&](const Scene& s) { return p.get(s) == p.get(scenes.front()); });
        if (agree || !tells(p, scenes)) continue;
        for (std::size_t k = 0; k < scenes.size(); ++k) {
            std::string prefix;
            if (of_one_set(p)) prefix = p.key.starts_with("velocity.") ? "velocity: " : "scalars: ";
            texts[k] += (texts[k].empty() ? "" : " · ") + prefix + words(p, p.get(scenes[k]));
        }
    }
    return texts;
}

std::vector<std::string> titles(const Setup& setup) {
    std::vector<std::string> result = differences(lane_scenes(setup));
    for (std::size_t k = 0; k < result.size(); ++k) {
        if (!setup.lanes[k].name.empty()) result[k] = setup.lanes[k].name;
        if (result[k].empty()) result[k] = "Lane " + std::to_string(k + 1);
    }
    return result;
}

}  // namespace whorl
