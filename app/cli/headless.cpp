#include "app/cli/headless.h"

#include <cstdio>

#include "app/views/views.h"
#include "app/window/egl_context.h"
#include "core/io/png.h"
#include "core/scene/error.h"
#include "core/scene/parameters.h"
#include "core/schemes/suggest.h"

namespace whorl::app {
namespace {

const ColourMap* map_of(const RunArguments& arguments) {
    if (arguments.map.empty()) return nullptr;
    if (const ColourMap* map = find_colour_map(arguments.map)) return map;
    std::vector<std::string_view> keys;
    for (const ColourMap& map : colour_maps()) keys.push_back(map.key);
    throw InputError("unknown map \"" + arguments.map + "\"; " + suggestion(arguments.map, keys));
}

}  // namespace

void apply_settings(Scene& scene, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) set_parameter(scene, setting);
    const std::string reason = conflict(scene);
    if (!reason.empty()) throw InputError(reason);
}

void check_outputs(const RunArguments& arguments) {
    view(arguments.view);
    map_of(arguments);
    for (const std::string& file : {arguments.csv, arguments.timing, arguments.picture}) {
        if (!file.empty() && file != "-") check_writable(file);
    }
    if (arguments.picture == "-") throw InputError("--picture takes the name of a file, not -");
}

void write_picture(const Lane& lane, Pool& pool, const RunArguments& arguments) {
    Snapshot snapshot;
    take_snapshot(lane, pool, snapshot);
    EglContext context;
    PictureRenderer renderer;
    const PictureStyle style{.view = &view(arguments.view),
                             .map = map_of(arguments),
                             .crisp = arguments.crisp,
                             .light = arguments.light};
    write_png(arguments.picture, picture_of(snapshot, style, renderer));
    say_written("picture", arguments.picture);
}

void say_written(const std::string& what, const std::string& file) {
    if (file != "-") std::fprintf(stderr, "wrote %s: %s\n", what.c_str(), file.c_str());
}

}  // namespace whorl::app
