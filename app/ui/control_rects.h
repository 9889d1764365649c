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
struct ControlRect {
    float x, y, width, height;
    bool operator==(const ControlRect&) const = default;
};

/// The part of a rect within a window's clip rectangle, which may be empty.
inline ControlRect clipped(const ControlRect& rect, float low_x, float low_y, float high_x, float high_y) {
    const float x = std::max(rect.x, low_x);
    const float y = std::max(rect.y, low_y);
    return {x, y, std::min(rect.x + rect.width, high_x) - x, std::min(rect.y + rect.height, high_y) - y};
}

class ControlRects {
  public:
    /// @param seen   what of the rect is in sight
    /// @param frame  in which it was drawn, ascending
    /// @return whether it lies elsewhere than it did, or is new
    bool note(std::string_view key, const ControlRect& rect, const ControlRect& seen, int frame) {
        frame_ = frame;
        const auto known = rects_.find(key);
        if (known == rects_.end()) {
            rects_.emplace(key, Known{rect, seen, frame});
            return true;
        }
        const bool moved = known->second.rect != rect;
        known->second = {rect, seen, frame};
        return moved;
    }

    /// What is in sight of something that was drawn in the newest frame or the one before.
    std::optional<ControlRect> in_sight(std::string_view key) const {
        const auto known = rects_.find(key);
        if (known == rects_.end() || known->second.frame + 1 < frame_) return {};
        const ControlRect& seen = known->second.seen;
        return seen.width > 0 && seen.height > 0 ? std::optional(seen) : std::nullopt;
    }

    /// The names of all that was ever drawn.
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& [name, known] : rects_) all.push_back(name);
        return all;
    }

  private:
    struct Known {
        ControlRect rect, seen;
        int frame;
    };

    std::map<std::string, Known, std::less<>> rects_;
    int frame_ = 0;
};

}  // namespace whorl::app
