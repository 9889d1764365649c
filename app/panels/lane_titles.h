// What the lanes are called, worked out only when their setup changes.
#pragma once

#include <string>
#include <vector>

#include "core/session/setup.h"

namespace whorl::app {

class LaneTitles {
  public:
    const std::vector<std::string>& of(const Setup& setup) {
        if (titles_.empty() || !(setup == setup_)) {
            setup_ = setup;
            titles_ = titles(setup);
        }
        return titles_;
    }

  private:
    Setup setup_;
    std::vector<std::string> titles_;
};

}  // namespace whorl::app
