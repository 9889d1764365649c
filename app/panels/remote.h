// What a person asks of the run: the one way from the panels to the player.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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

    /// The newest finished state. Valid until the next begin_frame.
    const Snapshot& snapshot() const { return *snapshot_; }
    /// The scene as chosen: the snapshot's, with the edits that have not acted yet.
    const Scene& scene() const { return scene_; }
    /// Key of the preset or experiment that was loaded last.
    const std::string& loaded() const { return loaded_; }

    /// Sets a parameter. A scheme that samples linearly takes linear interpolation along, and says so.
    void set(const Parameter& parameter, double value);
    void push(Command command) { player_.push(std::move(command)); }
    /// Begins another scene; a refusal is a notice.
    void load(std::string_view key, const Scene& scene);
    void set_loaded(std::string_view key) { loaded_ = key; }
    void restart();
    void play(bool playing) { player_.play(playing); }
    bool playing() const { return player_.playing(); }
    void step() { player_.step_once(); }
    void set_pace(Pace pace);
    Pace pace() const { return pace_; }
    Notices& notices() const { return notices_; }
    double steps_per_second() const { return player_.steps_per_second(); }

  private:
    struct Edit {
        const Parameter* parameter;
        double value;
        std::uint64_t serial;  ///< of the snapshot that was shown when it was made
        double time;
    };

    void push_edit(const Parameter& parameter, double value);
    void settle();

    Player& player_;
    Notices& notices_;
    const Snapshot* snapshot_ = nullptr;
    Scene scene_;
    std::string loaded_;
    Pace pace_;
    std::vector<Edit> edits_;  ///< pushed, not seen in a snapshot yet
};

}  // namespace whorl::app
