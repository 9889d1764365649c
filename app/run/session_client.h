// What a person asks of the run: the one way from the panels to the player.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "app/ui/notifications.h"
#include "core/scene/parameters.h"
#include "core/session/player.h"

namespace whorl::app {

/// Remembers what has been asked for until the run has done it, so that controls show the person's choice at
/// once however long a step takes.
class SessionClient {
  public:
    SessionClient(Player& player, Notifications& notifications)
        : player_(player), notifications_(notifications) {}

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
    /// The lane that was selected before, or else the next one. A place in session().lanes.
    std::size_t other() const;
    void select(std::size_t lane) { select_id(session_->ids[lane]); }
    /// The ids of setup()'s lanes; `unknown` for one that has not been made yet.
    const std::vector<int>& ids() const { return ids_; }
    static constexpr int unknown = -1;
    /// The selected lane's place in setup().lanes.
    std::size_t selected_in_setup() const;
    void select_id(int id);
    /// Whether the controls set the selected lane's overrides instead of the scene of all lanes.
    bool lane_only() const { return lane_only_; }
    void set_lane_only(bool lane_only);

    /// Sets a parameter, of all lanes or of the selected one. A scheme that samples linearly takes linear
    /// interpolation along, and says so.
    void set(const Parameter& parameter, double value);
    /// Whether a lane of setup() has a value of its own for a parameter.
    bool overridden(const Parameter& parameter, std::size_t lane) const;
    /// Takes the lanes' own values of a parameter away: of all lanes, or of the selected one.
    void drop_overrides(const Parameter& parameter);
    /// The lanes as they are chosen, each going on with its own fields: what changes of them begin with.
    Arrange arrangement() const;
    /// Other lanes; a refusal is a notification.
    /// @param select  the place of the lane to select then; else the selected one stays
    /// @return whether they were sent
    bool arrange(Arrange arrange, std::optional<std::size_t> select = {});
    void push(Command command);
    /// Begins another run; a refusal is a notification.
    /// @param set_aside  as Player::load takes it
    void load(std::string_view key, Recording recording, bool set_aside = false);
    std::unique_ptr<SetAside> take_set_aside() { return player_.take_set_aside(); }
    /// How many runs have been loaded: tells whether someone else has loaded one.
    int loads() const { return loads_; }
    /// Begins another scene with the lanes that are compared now; without them, and with a notification,
    /// where they do not go with it.
    void load_scene(std::string_view key, const Scene& scene);
    void set_loaded(std::string_view key) { loaded_ = key; }
    void restart() { push(Restart{}); }
    void play(bool playing) { player_.play(playing); }
    bool playing() const { return player_.playing(); }
    void step() { player_.step_once(); }
    void seek(long step) {
        player_.seek(step);
        sought_ = step;
    }
    /// The step that session() is on its way to, if any.
    std::optional<long> sought() const { return sought_; }
    void watch(const Watch& watch) { player_.watch(watch); }
    /// Asks for the present moment and the run up to it, see Player.
    void save() { player_.save(); }
    std::unique_ptr<Saved> take_saved() { return player_.take_saved(); }
    void set_pace(Pace pace);
    Pace pace() const { return pace_; }
    Notifications& notifications() const { return notifications_; }
    double steps_per_second() const { return player_.steps_per_second(); }

  private:
    /// A command that no snapshot shows yet.
    struct Pending {
        std::uint64_t ticket;
        Command command;
    };

    void settle();
    void act(const Command& command);
    void choose_scene();
    /// The scene as it would be with this value.
    Scene with(const Parameter& parameter, double value) const;
    void push_edit(const Parameter& parameter, double value);

    Player& player_;
    Notifications& notifications_;
    const SessionSnapshot* session_ = nullptr;
    std::optional<long> sought_;
    Setup setup_;
    Scene scene_;
    std::string loaded_;
    int loads_ = 0;
    Pace pace_;
    std::vector<int> ids_;  ///< of setup_'s lanes
    int selected_id_ = 0, previous_id_ = unknown;
    /// The place of a lane to select once a command has acted, and that command's ticket.
    std::optional<std::pair<std::uint64_t, std::size_t>> to_select_;
    bool lane_only_ = false;
    std::deque<Pending> pending_;
};

}  // namespace whorl::app
