// The values at the ends of the colour bar: following the field without flicker, or held.
#pragma once

#include "app/panels/quantity.h"

namespace whorl::app {

class ColourRange {
  public:
    float lo() const { return lo_; }
    float hi() const { return hi_; }

    bool held() const { return held_; }
    void hold(bool held) { held_ = held; }
    /// Sets both ends and holds them; ends that do not ascend are ignored.
    void set(float lo, float hi);

    /// Brings the range towards what a field spans, unless it is held. Another quantity starts afresh.
    /// @param seconds  since the last call
    void follow(const Quantity& quantity, const Field& field, double ambient, double seconds);

  private:
    const Quantity* quantity_ = nullptr;
    bool held_ = false;
    float reach_ = 1;  ///< from the neutral value to the end
    float lo_ = 0, hi_ = 1;
};

}  // namespace whorl::app
