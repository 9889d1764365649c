// What is known of the run: its newest snapshot, and the scene and lanes as they are chosen.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "app/views/lane_names.h"
#include "core/scene/parameters.h"
#include "core/session/player.h"

namespace whorl::app {

/// Shows a person's choice at once, however long a step takes: what has been asked for and has not acted yet
/// counts as done.
class RunView {
  public:
    RunView(const RunView&) = delete;
    RunView& operator=(const RunView&) = delete;

    /// The newest finished state of all lanes. Valid during a frame.
    const SessionSnapshot& session() const { return *session_; }
    /// That of the selected lane.
    const Snapshot& snapshot() const { return session_->lanes[selected()]; }
    /// What the lanes of session() are called.
    const LaneNames& names() const { return names_; }
    /// Scene and lanes as chosen: the snapshot's, with the edits that have not acted yet.
    const Setup& setup() const { return setup_; }
    /// The scene that the controls show and set: of all lanes, or the selected one's.
    const Scene& scene() const { return scene_; }
    /// Key of the preset, experiment or file that was loaded last.
    const std::string& loaded() const { return loaded_; }
    /// How many runs have been loaded: tells whether someone else has loaded one.
    int loads() const { return loads_; }

    /// The lane that is looked at where only one can be. A place in session().lanes.
    std::size_t selected() const;
    /// The lane that was selected before, or else the next one. A place in session().lanes.
    std::size_t other() const;
    /// The selected lane's place in setup().lanes.
    std::size_t selected_in_setup() const;
    /// The ids of setup()'s lanes; `unknown` for one that has not been made yet.
    const std::vector<int>& ids() const { return ids_; }
    static constexpr int unknown = -1;
    /// Whether the controls set the selected lane's overrides instead of the scene of all lanes.
    bool lane_only() const { return lane_only_; }
    /// Whether a lane of setup() has a value of its own for a parameter.
    bool overridden(const Parameter& parameter, std::size_t lane) const;
    /// The lanes as they are chosen, each going on with its own fields: what changes of them begin with.
    Arrange arrangement() const;

    /// The step that session() is on its way to, if any.
    std::optional<long> seek_target() const { return seek_target_; }
    bool playing() const { return player_.playing(); }
    Pace pace() const { return pace_; }
    double steps_per_second() const { return player_.steps_per_second(); }

  protected:
    explicit RunView(Player& player) : player_(player) {}
    ~RunView() = default;

    /// A command that no snapshot shows yet.
    struct Pending {
        std::uint64_t ticket;
        Command command;
    };

    /// Brings setup(), ids() and scene() up to the newest snapshot.
    void settle();
    /// Adds what a command will make of scene and lanes.
    void foresee(const Command& command);
    void choose_scene();

    Player& player_;
    const SessionSnapshot* session_ = nullptr;
    LaneNames names_;
    std::optional<long> seek_target_;
    Setup setup_;
    Scene scene_;
    std::string loaded_;
    int loads_ = 0;
    Pace pace_;
    std::vector<int> ids_;  ///< of setup_'s lanes
    int selected_id_ = 0, previous_id_ = unknown;
    bool lane_only_ = false;
    std::deque<Pending> pending_;
};

/// Whether two keys of parameters stand for the same value of a scheme set: one of both, or of the same one.
bool same_parameter(std::string_view a, std::string_view b);

/// "velocity.", "scalars." or nothing: which scheme set a parameter's key belongs to.
std::string_view scheme_set_prefix(std::string_view key);

}  // namespace whorl::app
