// The window for a set of lanes, drawn without a display.
#pragma once

#include <functional>

#include "app/labs/interpolation_state.h"
#include "app/labs/slice_state.h"
#include "app/window/features.h"
#include "tests/support/eventually.h"
#include "tests/support/headless_ui.h"

namespace whorl::app {

struct LanesWindow {
    LanesWindow(HeadlessUi& headless, Recording recording, const std::string& trace_path = {})
        : ui(headless), player(std::move(recording), 1), log(trace_path) {
        features.frames.add(16.7, 5);
        client.begin_frame();
    }

    /// A frame, as the main window makes it.
    void frame() {
        features.begin_frame(ColourRange::at_once);
        features.end_input();
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        ui.frame_of_windows([&] { features.draw(size.x, size.y); });
        if (after_frame) after_frame();
    }
    /// Frames until something is so.
    template <class IsSo>
    bool eventually(IsSo&& is_so) {
        return whorl::eventually([&] {
            frame();
            return is_so();
        });
    }
    /// Moves the pointer there and presses a button, over some frames, as ImGui needs them.
    void click(ImVec2 at, int button = 0) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = at;
        frame();
        io.MouseDown[button] = true;
        frame();
        io.MouseDown[button] = false;
        frame();
        io.MousePos = {-FLT_MAX, -FLT_MAX};
    }
    /// Double-clicks a lane's row: its name is typed then.
    void rename_lane(std::size_t lane) {
        const ControlRect row = log.rects().in_sight("lane=" + std::to_string(lane + 1)).value();
        for (int k = 0; k < 2; ++k) click({row.x + 0.5f * row.width, row.y + 0.5f * row.height});
    }

    HeadlessUi& ui;
    Player player;
    Notifications notifications;
    EventLog log;
    Features features{ui.theme, player, log, notifications};
    SessionClient& client = features.run;
    ViewSettings& view = features.view;
    MeasureView& measure_view = features.measures;
    FileRequests& files = features.files;
    History& history = features.history;
    LaneFields& fields = features.fields;
    const LaneNames& names = client.names();
    Layout& layout = features.layout;
    FieldViewports& place = features.viewports;
    Inspection& inspector = features.shared.of<Inspection>();
    Slice& slice = features.shared.of<Slice>();
    std::function<void()> after_frame;
};

}  // namespace whorl::app
