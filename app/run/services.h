// What the parts of the window may see and ask of each other.
#pragma once

namespace whorl::app {

class Ui;
class RunControl;
struct ViewSettings;
class LaneFields;
class History;
class FrameLog;
struct FileRequests;
struct RightColumn;
class LabWindows;
class SharedState;

/// Only `make` functions and the window see all of it: a part keeps the few that it uses.
struct Services {
    Ui& ui;           ///< look, controls, notifications, event log
    RunControl& run;  ///< a const RunView for those who only read
    ViewSettings& view;
    const LaneFields& fields;  ///< what the chosen view shows of every lane
    const History& history;
    const FrameLog& frames;
    FileRequests& files;
    RightColumn& right_column;
    LabWindows& labs;
    SharedState& shared;  ///< between the parts of one feature
};

}  // namespace whorl::app
