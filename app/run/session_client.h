// The window's end of the player: brings a new snapshot each frame, and hands out the run to be saved.
#pragma once

#include "app/run/run_control.h"

namespace whorl::app {

class SessionClient : public RunControl {
  public:
    SessionClient(Player& player, Notifications& notifications) : RunControl(player, notifications) {}

    /// Takes the newest snapshot and complaints; call once a frame, before anything reads.
    void begin_frame();
    void watch(const Watch& watch) { player_.watch(watch); }
    /// Asks for the present moment and the run up to it, see Player.
    void save() { player_.save(); }
    std::unique_ptr<Saved> take_saved() { return player_.take_saved(); }
    void set_loaded(std::string_view key) { loaded_ = key; }
};

}  // namespace whorl::app
