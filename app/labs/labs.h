// The labs: windows over the field in which one idea at a time can be tried.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Draws the open ones, each a window of its own. Call once a frame, between other windows.
void draw_labs(PanelContext& context);

/// Closes the window of a lab that lies over those of the others. @return whether there was one
bool close_top_lab(LabState& state);

/// A lab: what its chip says, where its window's state lies, and what fills it.
struct LabInfo {
    const char* key;
    const char* label;
    const char* help;
    const char* source;
    bool& (*open)(LabState&);
    void (*draw)(PanelContext&);
    float width, height;  ///< at first, points; of no use where it takes a column's
    /// Where it lies at first: over the middle of the screen, at its lower edge, or over a whole column: that
    /// of the measures, or of the controls while a lesson is read.
    enum class Anchor { Middle, Bottom, Side } anchor;
};
/// All labs.
std::span<const LabInfo> labs();

}  // namespace whorl::app
