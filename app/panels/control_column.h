// The left column: the program's name, the run's state, and all panels.
#pragma once

#include <string>
#include <vector>

#include "app/run/panel.h"
#include "app/run/run_view.h"
#include "app/ui/frame_log.h"
#include "app/ui/ui.h"

namespace whorl::app {

class ControlColumn {
  public:
    ControlColumn(Ui& ui, const RunView& run, const FrameLog& frames) : ui_(ui), run_(run), frames_(frames) {}

    void add(const PanelEntry& entry, const Services& services) {
        panels_.push_back({&entry, entry.make(services)});
    }

    /// Fills the current ImGui window.
    /// @param wanted  title of a panel to open and bring into sight; empty for none
    void draw(std::string_view wanted);
    /// Goes back to its head in the next frame.
    void to_top() { to_top_ = true; }

  private:
    struct Part {
        const PanelEntry* entry;
        std::unique_ptr<Panel> panel;
    };

    void state_lines();

    Ui& ui_;
    const RunView& run_;
    const FrameLog& frames_;
    std::vector<Part> panels_;
    bool to_top_ = false;
};

}  // namespace whorl::app
