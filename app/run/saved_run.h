// A person's own run and how it was looked at, kept while lessons show others in its place.
#pragma once

#include <optional>
#include <string>

#include "app/run/session_client.h"
#include "app/run/view_settings.h"

namespace whorl::app {

/// What of the view a lesson's step changes, and which lanes were selected, by their places.
struct KeptLook {
    const View* shown;
    bool difference;
    Compare compare;
    float wipe;
    ViewWindow window;
    std::size_t selected, other;
};

KeptLook look_of(const SessionClient& client, const ViewState& view);
void look_again(const KeptLook& look, SessionClient& client, ViewState& view);

/// Keeps one run at a time, from the load that takes its place until it is given back or no longer wanted.
class KeptRun {
  public:
    /// Begins another run in the place of the one on screen, which is kept if it is not the last that was
    /// begun here: else that which was kept then stays kept.
    void load_over(std::string_view name, const Recording& recording, SessionClient& client,
                   const ViewState& view);
    /// Whether a run is kept, and the one on screen is the last that was begun here: someone may have loaded
    /// another one since, which then stays.
    bool keeps(const SessionClient& client) const { return kept_ && client.loads() == own_load_; }
    /// Brings the kept run back, as soon as it can be.
    void give_back(SessionClient& client);
    /// Follows the run on its way; call once a frame.
    void update(SessionClient& client, ViewState& view);

  private:
    struct Kept {
        std::string name;
        long step;  ///< where it stood
        bool playing;
        KeptLook look;
        std::optional<Recording> recording;  ///< not before the player has handed it over
    };
    /// On its way back.
    struct Returning {
        Kept kept;
        int load;  ///< the client's count
        int left;  ///< the run before
        bool begun = false;
    };

    void take(SessionClient& client);
    void follow(SessionClient& client, ViewState& view);

    int own_load_ = -1;
    bool wanted_ = false;  ///< it is to be given back
    std::optional<Kept> kept_;
    std::optional<Returning> returning_;
};

}  // namespace whorl::app
