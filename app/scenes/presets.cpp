#include "app/scenes/presets.h"

#include <algorithm>
#include <vector>

#include "app/scenes/files.h"
#include "core/base/error.h"
#include "core/base/suggest.h"
#include "core/experiments/experiment.h"
#include "core/io/run_file.h"
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
    return parse_run(text, key).setup.scene;
}

Recording find_run(std::string_view name) {
    if (names_file(name)) {
        const std::string text = run_text(name);
        if (is_lesson(text))
            throw InputError(std::string(name) + ": this is a lesson; `whorl lesson " + std::string(name) +
                             "` reads it, and `whorl " + std::string(name) + "` shows it");
        return parse_run(text, name);
    }
    std::vector<std::string_view> keys;
    for (const Preset& preset : presets()) {
        if (preset.key == name) return parse_run(preset.text, preset.key);
        keys.push_back(preset.key);
    }
    for (const Experiment& e : experiments()) {
        if (e.info.key == name) return {.setup = {.scene = scene_of(e)}, .commands = {}};
        if (std::find(keys.begin(), keys.end(), e.info.key) == keys.end()) keys.push_back(e.info.key);
    }
    throw InputError("unknown preset \"" + std::string(name) + "\"; " + suggestion(name, keys));
}

}  // namespace whorl::app
