// Serves what is asked of files: pictures, runs, tables, animations, and runs to open.
#pragma once

#include <deque>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "app/charts/measure_view.h"
#include "app/figure/picture.h"
#include "app/run/background_tasks.h"
#include "app/run/file_requests.h"
#include "app/run/services.h"
#include "app/run/session_client.h"
#include "app/views/lane_fields.h"
#include "app/window/film_maker.h"
#include "app/window/replay_check.h"

namespace whorl::app {

/// Draws on the window's thread, between two frames and a band of a picture at a time; reads and writes on
/// others, so that no frame waits for a disk. What fails is a notification.
class FileService {
  public:
    FileService(const Services& services, SessionClient& run, const MeasureView& measures)
        : services_(services), run_(run), measures_(measures) {}

    /// The window was opened with a run.
    void opened(const Recording& recording, const std::string& name) { check_.expect(recording, name, 0); }
    /// Serves the requests; call once a frame, after the window is drawn.
    /// @param now  seconds of the window's clock
    void end_frame(double now);
    /// The tour was taken.
    void note_tour();
    /// Whether something that was asked for is on its way to a file.
    bool writes() const { return saving_ || !paintings_.empty() || background_tasks_.busy(); }

  private:
    /// What the next saved moment is for.
    struct PendingRequests {
        bool picture = false;
        bool run = false;
        std::optional<FilmOptions> film;
    };
    /// A picture and what it is drawn from.
    struct Painting {
        Saved saved;
        std::deque<LaneFields> fields;
        SheetRequest sheet;
        bool begun = false;
    };
    struct Opened {
        std::string name;
        std::variant<Recording, std::shared_ptr<const Lesson>> content;
    };

    void take_requests();
    void serve(Saved saved, double now);
    void take_picture(Saved saved);
    void paint();
    void save_run(Recording recording);
    void save_plots();
    void open();
    void take_opened(Opened opened);
    void follow_film(double now);
    void check_replay();

    const Services services_;
    SessionClient& run_;
    const MeasureView& measures_;
    PendingRequests pending_;
    bool saving_ = false;
    bool tour_noted_ = false;                          ///< once is enough, and so is one complaint
    std::unique_ptr<PictureRenderer> renderer_;        ///< made for the first picture
    std::deque<std::unique_ptr<Painting>> paintings_;  ///< the first is being drawn
    BackgroundTasks background_tasks_;
    FilmMaker film_;
    std::future<Opened> opening_;
    ReplayCheck check_;
};

}  // namespace whorl::app
