// Where things lie in the window, by their names.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace whorl::app {

/// A rectangle, pixels from the top left.
struct Place {
    float x, y, width, height;
    bool operator==(const Place&) const = default;
};

/// The part of a place within a window's clip rectangle, which may be empty.
inline Place clipped(const Place& place, float low_x, float low_y, float high_x, float high_y) {
    const float x = std::max(place.x, low_x);
    const float y = std::max(place.y, low_y);
    return {x, y, std::min(place.x + place.width, high_x) - x, std::min(place.y + place.height, high_y) - y};
}

class Places {
  public:
    /// @param seen   what of the place is in sight
    /// @param frame  in which it was drawn, ascending
    /// @return whether it lies elsewhere than it did, or is new
    bool note(std::string_view key, const Place& place, const Place& seen, int frame) {
        frame_ = frame;
        const auto known = places_.find(key);
        if (known == places_.end()) {
            places_.emplace(key, Known{place, seen, frame});
            return true;
        }
        const bool moved = known->second.place != place;
        known->second = {place, seen, frame};
        return moved;
    }

    /// What is in sight of something that was drawn in the newest frame or the one before.
    std::optional<Place> in_sight(std::string_view key) const {
        const auto known = places_.find(key);
        if (known == places_.end() || known->second.frame + 1 < frame_) return {};
        const Place& seen = known->second.seen;
        return seen.width > 0 && seen.height > 0 ? std::optional(seen) : std::nullopt;
    }

    /// The names of all that was ever drawn.
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& [name, known] : places_) all.push_back(name);
        return all;
    }

  private:
    struct Known {
        Place place, seen;
        int frame;
    };

    std::map<std::string, Known, std::less<>> places_;
    int frame_ = 0;
};

}  // namespace whorl::app
