#include "app/cli/headless.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>

#include "app/figure/picture.h"
#include "app/figure/session_sheet.h"
#include "app/render/egl_context.h"
#include "app/scenes/comparisons.h"
#include "app/scenes/files.h"
#include "app/scenes/presets.h"
#include "core/base/error.h"
#include "core/base/suggest.h"
#include "core/experiments/experiment.h"
#include "core/io/png.h"
#include "core/io/run_file.h"
#include "core/io/whole_file.h"
#include "core/scene/parameters.h"

namespace whorl::app {
namespace {

const ColourMap* map_of(const DrawArguments& arguments) {
    if (arguments.map.empty()) {
        // On paper what grows from 0 goes from white to black, as in the thesis.
        return arguments.light && !view(arguments.view).diverges() && !arguments.difference
                   ? find_colour_map("white-black")
                   : nullptr;
    }
    if (const ColourMap* map = find_colour_map(arguments.map)) return map;
    std::vector<std::string_view> keys;
    for (const ColourMap& map : colour_maps()) keys.push_back(map.key);
    throw InputError("unknown map \"" + arguments.map + "\"; " + suggestion(arguments.map, keys));
}

/// "0,0.5" as a range.
std::optional<Range> range_of(const DrawArguments& arguments) {
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

/// Before anything is drawn: whether there is something to show.
void check_fields(const SheetRequest& sheet, const SessionSnapshot& row, const DrawArguments& arguments) {
    const auto empty = [](const SheetCell& cell) { return cell.field == nullptr; };
    for (const SheetRow& cells : sheet.rows) {
        if (std::none_of(cells.cells.begin(), cells.cells.end(), empty)) continue;
        const std::string_view when = experiment(row.setup.scene.experiment).known;
        const std::string known = when.empty() ? "" : "; the exact solution is known " + std::string(when);
        throw InputError("there is no " + arguments.view + " to show at step " + std::to_string(row.step) +
                         " of " + row.setup.scene.experiment + known);
    }
}

}  // namespace

void apply_settings(Scene& scene, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) set_parameter(scene, setting);
    const std::string reason = conflict(scene);
    if (!reason.empty()) throw InputError(reason);
}

Scene experiment_scene(const std::string& name) {
    return names_file(name) ? find_run(name).setup.scene : scene_of(experiment(name));
}

Recording recording_for(const std::string& scene, const std::string& lanes,
                        const std::vector<std::string>& settings) {
    Recording recording = find_run(scene);
    Setup& setup = recording.setup;
    for (const std::string& setting : settings) set_parameter(setup.scene, setting);
    if (!lanes.empty()) {
        Lanes others = find_lanes(lanes);
        setup.lanes = std::move(others.lanes);
        setup.reference = others.reference;
    }
    lane_scenes(setup);
    const bool changed = !lanes.empty() || !settings.empty();
    if (changed) recording.digest = 0;
    return recording;
}

void check_picture(const std::string& option, const std::string& file) {
    if (!file.ends_with(".png"))
        throw InputError(option + " = " + file + ": pictures are PNG; give a name that ends in .png");
    check_writable(file);
}

struct Drawing::Canvas {
    EglContext context;
    PictureRenderer renderer;
};

Drawing::Drawing(const DrawArguments& arguments) : arguments_(arguments) {
    view(arguments.view);
    map_of(arguments);
    range_of(arguments);
    canvas_ = std::make_unique<Canvas>();
}

Drawing::~Drawing() = default;

Image Drawing::draw(std::span<const SessionSnapshot> rows, std::optional<Range> range) {
    std::deque<LaneFields> fields;
    PictureStyle style{.view = &view(arguments_.view), .difference = arguments_.difference};
    style.map = map_of(arguments_);
    style.range = range_of(arguments_);
    if (!style.range) style.range = range;
    style.crisp = arguments_.crisp;
    style.light = arguments_.light;
    SheetRequest sheet = sheet_of(rows, std::move(style), fields);
    check_fields(sheet, rows.back(), arguments_);
    const auto width = static_cast<float>(arguments_.width);
    const float suits = std::max(1.0f, width / sheet.cell_width);
    sheet.scale = std::min(arguments_.scale > 0 ? arguments_.scale : suits, largest_sheet_scale);
    if (width > 0) sheet.cell_width = width / sheet.scale;
    return canvas_->renderer.render(sheet);
}

Range Drawing::span(const SessionSnapshot& snapshot) const {
    LaneFields fields;
    fields.update(snapshot, view(arguments_.view), arguments_.difference);
    return fields.span();
}

void write_picture(const std::string& file, const Image& image, const Recording& recording) {
    const TextChunk text[] = {{"Software", "Whorl " WHORL_VERSION}, {run_chunk, write_run(recording)}};
    write_png(file, image, text);
    say_written("picture", file);
}

void say_written(const std::string& what, const std::string& file) {
    if (file != "-") std::fprintf(stderr, "wrote %s: %s\n", what.c_str(), file.c_str());
}

}  // namespace whorl::app
