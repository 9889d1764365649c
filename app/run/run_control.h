// What a person asks of the run.
#pragma once

#include <memory>

#include "app/run/run_view.h"
#include "app/ui/notifications.h"

namespace whorl::app {

/// Checks what is asked for, and says in a notification what is refused.
class RunControl : public RunView {
  public:
    void select(std::size_t lane) { select_id(session_->ids[lane]); }
    void select_id(int id);
    void set_lane_only(bool lane_only);

    /// Sets a parameter, of all lanes or of the selected one. A scheme that samples linearly takes linear
    /// interpolation along, and says so.
    void set(const Parameter& parameter, double value);
    /// Takes the lanes' own values of a parameter away: of all lanes, or of the selected one.
    void drop_overrides(const Parameter& parameter);
    /// Other lanes.
    /// @param select  the place of the lane to select then; else the selected one stays
    /// @return whether they were sent
    bool arrange(Arrange arrange, std::optional<std::size_t> select = {});
    void push(Command command);

    /// Begins another run.
    /// @param stash  as Player::load takes it
    void load(std::string_view key, Recording recording, bool stash = false);
    std::unique_ptr<StashedRun> take_stash() { return player_.take_stash(); }
    /// Begins another scene with the lanes that are compared now; without them, and with a notification,
    /// where they do not go with it.
    void load_scene(std::string_view key, const Scene& scene);
    void restart() { push(Restart{}); }
    void play(bool playing) { player_.play(playing); }
    void step() { player_.step_once(); }
    void seek(long step) {
        player_.seek(step);
        seek_target_ = step;
    }
    /// Goes `by` steps on or back, at the last known step by stepping on.
    void move_by(long by);
    void set_pace(Pace pace);
    Notifications& notifications() const { return notifications_; }

  protected:
    RunControl(Player& player, Notifications& notifications)
        : RunView(player), notifications_(notifications) {}
    ~RunControl() = default;

    Notifications& notifications_;
    /// The place of a lane to select once a command has acted, and that command's ticket.
    std::optional<std::pair<std::uint64_t, std::size_t>> to_select_;

  private:
    /// The scene as it would be with this value.
    Scene with(const Parameter& parameter, double value) const;
    void push_edit(const Parameter& parameter, double value);
};

}  // namespace whorl::app
