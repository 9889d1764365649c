#include "app/scenes/presets.h"

#include <algorithm>
#include <vector>

#include "core/experiments/experiment.h"
#include "core/io/scene_file.h"
#include "core/scene/error.h"
#include "core/schemes/suggest.h"
#include "scenes.h"  // made by CMake from app/scenes/*.toml

namespace whorl::app {

std::span<const Preset> presets() {
    static constexpr Preset table[] = {
        {"plume", scenes::plume_toml},                    //
        {"plume-obstacle", scenes::plume_obstacle_toml},  //
        {"shear-layer", scenes::shear_layer_toml},        //
        {"empty", scenes::empty_toml},                    //
    };
    return table;
}

Scene Preset::scene() const {
    return parse_scene(text, key);
}

Scene find_scene(std::string_view name) {
    if (name.ends_with(".toml") || name.find('/') != std::string_view::npos) return read_scene(name);
    std::vector<std::string_view> keys;
    for (const Preset& preset : presets()) {
        if (preset.key == name) return preset.scene();
        keys.push_back(preset.key);
    }
    for (const Experiment& e : experiments()) {
        if (e.info.key == name) return scene_of(e);
        if (std::find(keys.begin(), keys.end(), e.info.key) == keys.end()) keys.push_back(e.info.key);
    }
    throw InputError("unknown preset \"" + std::string(name) + "\"; " + suggestion(name, keys));
}

}  // namespace whorl::app
