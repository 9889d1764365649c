#include "app/window/file_service.h"

#include <chrono>

#include "app/charts/measure_tabs.h"
#include "app/charts/plots_csv.h"
#include "app/figure/session_sheet.h"
#include "app/lessons/lesson.h"
#include "app/run/history.h"
#include "app/run/view_settings.h"
#include "app/scenes/files.h"
#include "app/scenes/presets.h"
#include "app/tutorial/tour_memory.h"
#include "app/ui/ui.h"
#include "app/window/numbered_path.h"
#include "core/io/png.h"
#include "core/io/run_file.h"
#include "core/io/whole_file.h"

namespace whorl::app {
namespace {

/// As the window shows it: all lanes, or one; a range that is not held is the moment's own, whether the run
/// plays or stands.
PictureStyle style_of(const Services& services, std::vector<SheetPlot> plots) {
    const ViewSettings& view = services.view;
    PictureStyle style{.view = view.shown, .difference = view.difference};
    if (view.compare == Compare::One) style.alone = services.run.selected();
    style.map = &view.map();
    if (view.range.held()) style.range = view.range.ends();
    style.window = view.window;
    style.crisp = view.crisp;
    style.light = services.files.picture.light;
    style.arrows = view.arrows;
    style.scale = static_cast<float>(services.files.picture.scale);
    style.plots = std::move(plots);
    return style;
}

constexpr const char* no_picture = "No picture: ";

void warn_no_picture(Ui& ui, const std::exception& e) {
    ui.notifications.warn(std::string(no_picture) + e.what());
    ui.log.event("picture-failed", e.what());
}

constexpr const char* not_complete =
    "the recording is full, so that it cannot bring this run back: reset to begin another one";

}  // namespace

void FileService::end_frame(double now) {
    take_requests();
    if (const std::unique_ptr<Saved> saved = run_.take_saved()) serve(std::move(*saved), now);
    paint();
    if (std::exchange(services_.files.save_plots, false)) save_plots();
    open();
    follow_film(now);
    check_replay();
    background_tasks_.end_frame(services_.ui.notifications, services_.ui.log);
}

void FileService::take_requests() {
    FileRequests& files = services_.files;
    pending_.picture |= std::exchange(files.take_picture, false);
    pending_.run |= std::exchange(files.save_run, false);
    if (files.make_film && !film_.busy()) pending_.film = files.make_film;
    files.make_film.reset();
    if (saving_ || (!pending_.picture && !pending_.run && !pending_.film)) return;
    if (run_.seek_target()) return;  // it is about the step that is on its way
    saving_ = true;
    run_.save();
}

void FileService::serve(Saved saved, double now) {
    saving_ = false;
    const PendingRequests pending = std::exchange(pending_, {});
    Notifications& notifications = services_.ui.notifications;
    if (!saved.complete) {
        if (pending.picture) notifications.warn(std::string("This picture carries no run: ") + not_complete);
        if (pending.run) notifications.warn(std::string("Run not saved: ") + not_complete);
        if (pending.film) notifications.warn(std::string("No animation: ") + not_complete);
    } else {
        if (pending.run) save_run(saved.recording);
        if (pending.film) {
            film_.start(saved.recording, *pending.film, now);
            notifications.info("Recording the animation; the window goes on");
            services_.ui.log.event("film-started", "");
        }
    }
    if (pending.picture) take_picture(std::move(saved));
}

void FileService::take_picture(Saved saved) {
    try {
        auto painting = std::make_unique<Painting>();
        painting->saved = std::move(saved);
        const SessionSnapshot& session = painting->saved.snapshot;
        std::vector<SheetPlot> plots;
        if (services_.files.picture.plots) plots = plots_of(services_.history, session, measures_);
        painting->sheet = sheet_of({&session, 1}, style_of(services_, std::move(plots)), painting->fields);
        paintings_.push_back(std::move(painting));
    } catch (const std::exception& e) {
        warn_no_picture(services_.ui, e);
    }
}

/// A band a frame.
void FileService::paint() {
    if (paintings_.empty()) return;
    try {
        Painting& now = *paintings_.front();
        if (!renderer_) renderer_ = std::make_unique<PictureRenderer>();
        if (!std::exchange(now.begun, true)) return renderer_->begin(std::move(now.sheet));
        std::optional<Image> image = renderer_->draw_band();
        if (!image) return;
        background_tasks_.add({"picture", "Picture written to ", no_picture,
                               [image = *std::move(image), recording = std::move(now.saved.recording),
                                complete = now.saved.complete] {
                                   const auto path = numbered_path(".png");
                                   std::vector<TextChunk> text{{"Software", "Whorl " WHORL_VERSION}};
                                   if (complete) text.emplace_back(run_chunk, write_run(recording));
                                   write_png(path, image, text);
                                   return path.string();
                               }});
    } catch (const std::exception& e) {
        warn_no_picture(services_.ui, e);
    }
    paintings_.pop_front();
}

void FileService::save_run(Recording recording) {
    background_tasks_.add(
        {"run-saved", "Run written to ", "Run not saved: ", [recording = std::move(recording)] {
             const auto path = numbered_path(".toml");
             write_whole_file(path, write_run(recording));
             return path.string();
         }});
}

void FileService::save_plots() {
    const SessionSnapshot& session = run_.session();
    std::vector<CsvLane> lanes;
    for (std::size_t k = 0; k < session.lanes.size(); ++k)
        lanes.push_back({run_.names().name(k), services_.history.lane(session.ids[k])});
    background_tasks_.add({"csv", "Plots written to ", "Plots not saved: ", [lanes = std::move(lanes)] {
                               const auto path = numbered_path(".csv");
                               write_whole_file(path, plots_csv(lanes));
                               return path.string();
                           }});
}

void FileService::note_tour() {
    if (std::exchange(tour_noted_, true)) return;
    background_tasks_.add({"tour-seen", "", "The tour will come again at the next start: ", [] {
                               remember_tour();
                               return std::string();
                           }});
}

void FileService::open() {
    Notifications& notifications = services_.ui.notifications;
    if (opening_.valid() && opening_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        try {
            take_opened(opening_.get());
        } catch (const std::exception& e) {
            services_.files.open_outcome = e.what();
            // The dialog that asked for it says why.
            if (!services_.files.dialog) notifications.warn(std::string("Not opened: ") + e.what());
            services_.ui.log.event("opened-failed", e.what());
        }
    }
    if (!services_.files.open || opening_.valid()) return;
    opening_ = std::async(std::launch::async, [name = *services_.files.open]() -> Opened {
        if (names_file(name) && is_lesson(run_text(name)))
            return {name, std::make_shared<const Lesson>(find_lesson(name))};
        return {name, find_run(name)};
    });
    services_.files.open.reset();
}

void FileService::take_opened(Opened opened) {
    if (auto* recording = std::get_if<Recording>(&opened.content)) {
        const long step = recording->step;
        check_.expect(*recording, opened.name, run_.session().run + 1);
        run_.load(opened.name, std::move(*recording));
        if (names_file(opened.name)) {
            run_.play(false);
            services_.ui.notifications.info("Opened " + opened.name +
                                            (step > 0 ? " at step " + std::to_string(step) : ""));
        }
    } else {
        services_.files.lesson = std::get<1>(opened.content);
    }
    services_.files.open_outcome = "";
    services_.ui.log.event("opened", opened.name);
}

void FileService::follow_film(double now) {
    if (std::exchange(services_.files.cancel_film, false)) film_.cancel();
    services_.files.filming = film_.progress(now);
    const auto outcome = film_.take_outcome();
    if (!outcome) return;
    services_.files.filming.reset();
    Notifications& notifications = services_.ui.notifications;
    if (outcome->cancelled) {
        notifications.info("Animation cancelled; nothing of it is left");
        services_.ui.log.event("film-cancelled", "");
    } else if (outcome->error.empty()) {
        notifications.info("Animation written to " + outcome->path);
        services_.ui.log.event("film", outcome->path);
    } else {
        notifications.warn("No animation: " + outcome->error);
        services_.ui.log.event("film-failed", outcome->error);
    }
}

void FileService::check_replay() {
    const auto same = check_.follow(run_.session(), run_.loaded());
    if (!same) return;
    services_.ui.log.event("replayed", *same ? "same" : "different");
    if (!*same)
        services_.ui.notifications.warn(
            "This is not quite the recorded run: another version or machine has made it");
}

}  // namespace whorl::app
