// The lanes, a row each: a click selects one, a double click renames it.
#pragma once

#include <string>

#include "app/run/run_control.h"
#include "app/ui/ui.h"

namespace whorl::app {

class LaneList {
  public:
    LaneList(Ui& ui, RunControl& run) : ui_(ui), run_(run) {}

    void draw(const LaneNames& names);

  private:
    /// The name that is being typed.
    struct Name {
        int id = -1;  ///< of the lane; none if negative
        bool begun = false;
        char text[48] = "";
    };

    void row(std::size_t lane, const std::string& name, const std::string& differs);
    void draw_row(std::size_t lane, const std::string& name, const std::string& differs, ImVec2 corner,
                  ImVec2 end) const;
    void name_field(std::size_t lane);
    void rename(int id, const std::string& name);

    Ui& ui_;
    RunControl& run_;
    Name name_;
};

}  // namespace whorl::app
