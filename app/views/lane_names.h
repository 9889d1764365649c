// What the lanes are called on screen.
#pragma once

#include <string>
#include <vector>

#include "core/session/setup.h"

namespace whorl::app {

/// Names of the lanes of a sound setup, worked out anew when it changes.
class LaneNames {
  public:
    /// @pre lane_scenes(setup) succeeds
    void update(const Setup& setup);

    std::size_t size() const { return names_.size(); }
    /// Its name, else what differs, else its number.
    const std::string& name(std::size_t lane) const { return names_[lane]; }
    /// What differs, where its name does not say that already; may be empty.
    const std::string& difference(std::size_t lane) const { return differences_[lane]; }

  private:
    Setup setup_;
    std::vector<std::string> names_, differences_;
};

/// A lane's difference in words, where there may be none.
inline std::string_view said_of(std::string_view difference) {
    return difference.empty() ? "The scene as it is set for all lanes." : difference;
}

}  // namespace whorl::app
