#include "app/scenes/comparisons.h"

#include "app/scenes/files.h"
#include "comparison_texts.h"  // made by CMake from app/scenes/comparisons/*.toml
#include "core/base/error.h"
#include "core/base/suggest.h"

namespace whorl::app {

std::span<const Comparison> comparisons() {
    static constexpr Comparison table[] = {
        {"thesis-five", comparison_texts::thesis_five_toml},      //
        {"aslam-zeta", comparison_texts::aslam_zeta_toml},        //
        {"aslam-weights", comparison_texts::aslam_weights_toml},  //
        {"aslam-family", comparison_texts::aslam_family_toml},    //
        {"tracers", comparison_texts::tracers_toml},              //
        {"limiters", comparison_texts::limiters_toml},            //
    };
    return table;
}

Lanes Comparison::lanes() const {
    return parse_lanes(text, key);
}

Lanes find_lanes(std::string_view name) {
    if (names_file(name)) return parse_lanes(run_text(name), name);
    std::vector<std::string_view> keys;
    for (const Comparison& comparison : comparisons()) {
        if (comparison.key == name) return comparison.lanes();
        keys.push_back(comparison.key);
    }
    throw InputError("unknown comparison \"" + std::string(name) + "\"; " + suggestion(name, keys));
}

}  // namespace whorl::app
