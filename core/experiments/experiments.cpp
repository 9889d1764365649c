// The table of experiments, a line each.
#include <array>
#include <vector>

#include "core/base/error.h"
#include "core/base/suggest.h"
#include "core/experiments/experiment.h"

namespace whorl {

Experiment empty();
Experiment plume();
Experiment shear_layer();
Experiment translation_1d();
Experiment translation();
Experiment rotation();
Experiment rest();
Experiment zalesak();
Experiment taylor_green();

std::span<const Experiment> experiments() {
    static const std::array table{
        empty(),           //
        plume(),           //
        shear_layer(),     //
        translation_1d(),  //
        translation(),     //
        rotation(),        //
        rest(),            //
        zalesak(),         //
        taylor_green(),    //
    };
    return table;
}

const Experiment& experiment(std::string_view key) {
    std::vector<std::string_view> keys;
    for (const Experiment& e : experiments()) {
        if (e.info.key == key) return e;
        keys.push_back(e.info.key);
    }
    throw InputError("unknown experiment \"" + std::string(key) + "\"; " + suggestion(key, keys));
}

Scene scene_of(const Experiment& e) {
    Scene scene;
    scene.experiment = e.info.key;
    scene.title = e.info.label;
    if (e.setup) e.setup(scene);
    return scene;
}

}  // namespace whorl
