// What a person asks of the run: the one way from the panels to the player.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "app/panels/notices.h"
#include "core/scene/parameters.h"
#include "core/session/player.h"

namespace whorl::app {

/// Remembers what has been asked for until the run has done it, so that controls show the person's choice at
/// once however long a step takes.
class Remote {
  public:
    Remote(Player& player, Notices& notices) : player_(player), notices_(notices) {}

    /// Takes the newest snapshot and complaints; call once a frame, before anything reads.
    void begin_frame();

    /// The newest finished state of all lanes. Valid until the next begin_frame.
    const SessionSnapshot& session() const { return *session_; }
    /// That of the selected lane.
    const Snapshot& snapshot() const { return session_->lanes[selected()]; }
    /// Scene and lanes as chosen: the snapshot's, with the edits that have not acted yet.
    const Setup& setup() const { return setup_; }
    /// The scene that the controls show and set: of all lanes, or the selected one's.
    const Scene& scene() const { return scene_; }
    /// Key of the preset, experiment or file that was loaded last.
    const std::string& loaded() const { return loaded_; }

    /// The lane that is looked at where only one can be. A place in session().lanes.
    std::size_t selected() const;
    void select(std::size_t lane);
    /// Whether the controls set the selected lane's overrides instead of the scene of all lanes.
    bool lane_only() const { return lane_only_; }
    void set_lane_only(bool lane_only);

    /// Sets a parameter, of all lanes or of the selected one. A scheme that samples linearly takes linear
    /// interpolation along, and says so.
    void set(const Parameter& parameter, double value);
    /// Whether the selected lane has a value of its own for a parameter.
    bool overridden(const Parameter& parameter) const;
    /// Other lanes; a refusal is a notice.
    void arrange(Arrange arrange);
    void push(Command command);
    /// Begins another run; a refusal is a notice.
    void load(std::string_view key, Recording recording);
    void set_loaded(std::string_view key) { loaded_ = key; }
    void restart() { push(Restart{}); }
    void play(bool playing) { player_.play(playing); }
    bool playing() const { return player_.playing(); }
    void step() { player_.step_once(); }
    void seek(long step) { player_.seek(step); }
    std::optional<long> sought() const { return player_.sought(); }
    /// Asks for the present moment and the run up to it, see Player.
    void save() { player_.save(); }
    std::unique_ptr<Saved> take_saved() { return player_.take_saved(); }
    void set_pace(Pace pace);
    Pace pace() const { return pace_; }
    Notices& notices() const { return notices_; }
    double steps_per_second() const { return player_.steps_per_second(); }

  private:
    /// A command that no snapshot shows yet.
    struct Pending {
        std::uint64_t ticket;
        Command command;
    };

    void settle();
    void choose_scene();
    /// The scene as it would be with this value.
    Scene with(const Parameter& parameter, double value) const;
    void push_edit(const Parameter& parameter, double value);

    Player& player_;
    Notices& notices_;
    const SessionSnapshot* session_ = nullptr;
    Setup setup_;
    Scene scene_;
    std::string loaded_;
    Pace pace_;
    int selected_id_ = 0;
    bool lane_only_ = false;
    std::deque<Pending> pending_;
};

}  // namespace whorl::app
