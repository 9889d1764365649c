// The values at the ends of the colour bar: following the field without flicker, or held.
#pragma once

#include "app/views/views.h"

namespace whorl::app {

class ColourRange {
  public:
    Range ends() const { return ends_; }
    bool held() const { return held_; }
    void hold(bool held) { held_ = held; }
    /// Sets both ends and holds them; ends that do not ascend are ignored.
    void set(Range ends);

    /// Brings the range towards what a view's fields span, unless it is held. Another view starts afresh, and
    /// so do differences in it.
    /// @param seconds  since the last call; `at_once` goes all the way
    static constexpr double at_once = 1e6;
    void follow(const View& view, bool difference, Range span, double seconds);

  private:
    const View* view_ = nullptr;
    bool difference_ = false;
    bool held_ = false;
    Range ends_{0, 1};
};

}  // namespace whorl::app
