#include "app/cli/headless.h"

#include <charconv>
#include <cstdio>
#include <optional>

#include "app/views/views.h"
#include "app/window/egl_context.h"
#include "core/io/png.h"
#include "core/io/whole_file.h"
#include "core/scene/error.h"
#include "core/scene/parameters.h"
#include "core/schemes/suggest.h"

namespace whorl::app {
namespace {

const ColourMap* map_of(const RunArguments& arguments) {
    if (arguments.map.empty()) {
        // On paper what grows from 0 goes from white to black, as in the thesis.
        return arguments.light && view(arguments.view).middle == nullptr ? find_colour_map("white-black")
                                                                         : nullptr;
    }
    if (const ColourMap* map = find_colour_map(arguments.map)) return map;
    std::vector<std::string_view> keys;
    for (const ColourMap& map : colour_maps()) keys.push_back(map.key);
    throw InputError("unknown map \"" + arguments.map + "\"; " + suggestion(arguments.map, keys));
}

/// "0,0.5" as a range.
std::optional<Range> range_of(const RunArguments& arguments) {
    if (arguments.range.empty()) return std::nullopt;
    const char* const end = arguments.range.data() + arguments.range.size();
    Range range{};
    const auto [comma, low_error] = std::from_chars(arguments.range.data(), end, range.lo);
    if (low_error == std::errc{} && comma != end && *comma == ',') {
        const auto [last, high_error] = std::from_chars(comma + 1, end, range.hi);
        if (high_error == std::errc{} && last == end && range.lo < range.hi) return range;
    }
    throw InputError("--range = \"" + arguments.range + "\" is not two rising numbers, as 0,0.5");
}

}  // namespace

void apply_settings(Scene& scene, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) set_parameter(scene, setting);
    const std::string reason = conflict(scene);
    if (!reason.empty()) throw InputError(reason);
}

struct PictureOutput::Canvas {
    EglContext context;
    PictureRenderer renderer;
};

PictureOutput::PictureOutput(const RunArguments& arguments) : arguments_(arguments) {
    view(arguments.view);
    map_of(arguments);
    range_of(arguments);
    if (!arguments.picture.empty() && !arguments.picture.ends_with(".png")) {
        throw InputError("--picture = " + arguments.picture +
                         ": pictures are PNG; give a name that ends in .png");
    }
    if (arguments.picture.empty() && (arguments.view != "density" || !arguments.map.empty())) {
        throw InputError("--view and --map are of the picture; give --picture FILE.png too");
    }
    for (const std::string& file : {arguments.csv, arguments.timing, arguments.picture}) {
        if (!file.empty() && file != "-") check_writable(file);
    }
    if (!arguments.picture.empty()) canvas_ = std::make_unique<Canvas>();
}

PictureOutput::~PictureOutput() = default;

void PictureOutput::write(const Lane& lane, Pool& pool) {
    if (!canvas_) return;
    Snapshot snapshot;
    take_snapshot(lane, pool, snapshot);
    const std::optional<Range> range = range_of(arguments_);
    const PictureStyle style{.view = &view(arguments_.view),
                             .map = map_of(arguments_),
                             .range = range ? &*range : nullptr,
                             .crisp = arguments_.crisp,
                             .light = arguments_.light,
                             .width = arguments_.width};
    write_png(arguments_.picture, picture_of(snapshot, style, canvas_->renderer));
    say_written("picture", arguments_.picture);
}

void say_written(const std::string& what, const std::string& file) {
    if (file != "-") std::fprintf(stderr, "wrote %s: %s\n", what.c_str(), file.c_str());
}

}  // namespace whorl::app
