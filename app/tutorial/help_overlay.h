// The keys and gestures, over everything.
#pragma once

#include <span>

#include "app/run/tool.h"
#include "app/tutorial/tour.h"
#include "app/ui/ui.h"

namespace whorl::app {

class HelpOverlay {
  public:
    HelpOverlay(Ui& ui, Tour& tour) : ui_(ui), tour_(tour) {}

    bool open = false;

    /// Draws the help if it is open; a click anywhere closes it.
    void draw(std::span<const KeyHelp> mouse, std::span<const KeyHelp> keys);

  private:
    Ui& ui_;
    Tour& tour_;
};

}  // namespace whorl::app
