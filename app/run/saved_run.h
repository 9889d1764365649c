// A person's own run and how it was looked at, saved while lessons show others in its place.
#pragma once

#include <optional>
#include <string>

#include "app/run/run_control.h"
#include "app/run/view_settings.h"

namespace whorl::app {

/// What of the view a lesson's step changes, and which lanes were selected, by their places.
struct SavedView {
    const View* shown;
    bool difference;
    Compare compare;
    float wipe;
    ViewWindow window;
    std::size_t selected, other;
};

SavedView save_view(const RunControl& run, const ViewSettings& view);
void restore_view(const SavedView& saved, RunControl& run, ViewSettings& view);

/// Keeps one run at a time, from the load that takes its place until it is given back or no longer wanted.
class SavedRun {
  public:
    /// Begins another run in the place of the one on screen, which is saved if it is not the last that was
    /// begun here: else that which was saved then stays saved.
    void load_over(std::string_view name, const Recording& recording, RunControl& run,
                   const ViewSettings& view);
    /// Whether a run is saved, and the one on screen is the last that was begun here: someone may have loaded
    /// another one since, which then stays.
    bool holds(const RunControl& run) const { return saved_ && run.loads() == own_load_; }
    /// Brings the saved run back, as soon as it can be.
    void give_back(RunControl& run);
    /// Follows the run on its way; call once a frame.
    void update(RunControl& run, ViewSettings& view);

  private:
    struct Entry {
        std::string name;
        long step;  ///< where it stood
        bool playing;
        SavedView view;
        std::optional<Recording> recording;  ///< not before the player has handed it over
    };
    /// On its way back.
    struct Returning {
        Entry saved;
        int load;  ///< the run's count
        int left;  ///< the run before
        bool begun = false;
    };

    void take(RunControl& run);
    void follow(RunControl& run, ViewSettings& view);

    int own_load_ = -1;
    bool wanted_ = false;  ///< it is to be given back
    std::optional<Entry> saved_;
    std::optional<Returning> returning_;
};

}  // namespace whorl::app
