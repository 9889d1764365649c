// What a session begins with: a scene, and the lanes that vary it.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace whorl {

/// A parameter and its value, as `--set key=value` gives them.
struct SetParameter {
    std::string key;
    std::string value;
    bool operator==(const SetParameter&) const = default;
};

/// One of the simulations that run side by side, by what it does otherwise than the scene.
struct LaneSetup {
    std::string name{};                     ///< empty for one that is called by what differs
    std::vector<SetParameter> overrides{};  ///< over the scene's own values, in order
    int refine = 1;  ///< 1, 2, 4 or 8: so many times the resolution, at so small a part of Δt
    bool operator==(const LaneSetup&) const = default;

    /// Sets an override, in the place of one of the same key.
    void set(SetParameter override);
};

/// No reference lane.
inline constexpr int no_reference = -1;

struct Setup {
    Scene scene;
    std::vector<LaneSetup> lanes{LaneSetup{}};
    int reference = no_reference;  ///< index of the lane that others are measured against
    bool operator==(const Setup&) const = default;

    static constexpr int max_lanes = 6;
    static constexpr int refinements[] = {1, 2, 4, 8};
};

/// What a lane runs.  @throws InputError that names the lane
Scene lane_scene(const Scene& scene, const LaneSetup& lane);

/// The scenes of all lanes.  @throws InputError if there are none or too many lanes, or a lane's choices do
/// not go together
std::vector<Scene> lane_scenes(const Setup& setup);

/// What differs between scenes: for each the values, in words, of the parameters in which they do not all
/// agree; empty where they do.
std::vector<std::string> differences(const std::vector<Scene>& scenes);

/// What a lane is called: its name, else what differs, else its number.
std::vector<std::string> titles(const Setup& setup);

}  // namespace whorl
