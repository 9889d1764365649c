// The windows of the labs: which there are, which are open, and where they lie.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "app/run/lab.h"

namespace whorl::app {

class LabWindows {
  public:
    struct Window {
        const LabEntry* entry;
        std::unique_ptr<Lab> lab;
    };
    /// The column that a lab may stand over: its left edge and width, pixels.
    struct Side {
        float x = 0, width = 0;
        bool beside_lessons = false;  ///< it is another one then
    };

    void add(const LabEntry& entry, const Services& services) {
        windows_.push_back({&entry, entry.make(services)});
    }
    std::span<const Window> all() const { return windows_; }
    /// Whether a lab is open, by its key; may be set.
    bool& open(std::string_view key) const;

    /// Draws the open ones. Call once a frame, between other windows.
    void draw(Ui& ui, const Side& side);
    /// Whether the pointer is on one of them: the field below takes no strokes.
    bool under_pointer() const { return under_pointer_; }
    /// Closes the one that lies over the others. @return whether there was one
    bool close_top() const;

  private:
    std::vector<Window> windows_;
    bool stood_beside_lessons_ = false;  ///< where a lab with a column was put last
    bool under_pointer_ = false;
};

}  // namespace whorl::app
