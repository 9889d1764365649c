#include "app/window/picture_taker.h"

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "core/io/png.h"
#include "core/io/run_file.h"

namespace whorl::app {
namespace {

/// The first of whorl-0001.png, whorl-0002.png … that is free in the current directory.
std::filesystem::path next_path() {
    for (int k = 1;; ++k) {
        char name[32];
        std::snprintf(name, sizeof name, "whorl-%04d.png", k);
        std::error_code ignored;
        if (!std::filesystem::exists(name, ignored)) return std::filesystem::absolute(name, ignored);
    }
}

}  // namespace

void PictureTaker::end_frame(const Snapshot& snapshot, const ViewState& view, Notices& notices,
                             Trace& trace) {
    if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const Outcome outcome = writing_.get();
        if (outcome.error.empty()) {
            notices.info("Picture written to " + outcome.path);
            trace.event("picture", outcome.path);
        } else {
            notices.warn("No picture: " + outcome.error);
            trace.event("picture-failed", outcome.error);
        }
    }
    if (asked_ && !writing_.valid()) {
        asked_ = false;
        take(snapshot, view, notices);
    }
}

void PictureTaker::take(const Snapshot& snapshot, const ViewState& view, Notices& notices) {
    try {
        if (!renderer_) renderer_ = std::make_unique<PictureRenderer>();
        const Range ends = view.range.ends();
        Image image = picture_of(snapshot,
                                 {.view = view.shown,
                                  .map = &view.map(),
                                  .range = &ends,
                                  .crisp = view.crisp,
                                  .arrows = view.arrows},
                                 *renderer_);
        writing_ = std::async(
            std::launch::async,
            [image = std::move(image), run = write_run({.setup = {.scene = snapshot.scene}})]() -> Outcome {
                const std::filesystem::path path = next_path();
                try {
                    const TextChunk text[] = {{"Software", "Whorl " WHORL_VERSION}, {run_chunk, run}};
                    write_png(path, image, text);
                    return {path.string(), ""};
                } catch (const std::exception& e) {
                    return {path.string(), e.what()};
                }
            });
    } catch (const std::exception& e) {
        notices.warn(std::string("No picture: ") + e.what());
    }
}

}  // namespace whorl::app
