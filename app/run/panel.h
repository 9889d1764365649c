// A titled group of controls in the left column.
#pragma once

#include <memory>
#include <string_view>

#include "app/run/services.h"

namespace whorl::app {

class Panel {
  public:
    virtual ~Panel() = default;
    /// Fills the current ImGui window, from the cursor down.
    virtual void draw() = 0;
};

struct PanelEntry {
    std::string_view key;
    const char* title;
    bool open = true;  ///< at the start
    std::unique_ptr<Panel> (*make)(const Services&);
};

}  // namespace whorl::app
