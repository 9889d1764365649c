// The three columns of the window for a set of lanes, drawn without a display.
#pragma once

#include <functional>

#include "app/charts/measure_column.h"
#include "app/labs/labs.h"
#include "app/panels/control_column.h"
#include "app/panels/field_area.h"
#include "app/window/layout.h"
#include "tests/support/eventually.h"
#include "tests/support/headless_ui.h"

namespace whorl::app {

struct LanesWindow {
    LanesWindow(HeadlessUi& headless, Recording recording, const std::string& trace_path = {})
        : ui(headless), player(std::move(recording), 1), log(trace_path) {
        frames.add(16.7, 5);
        client.begin_frame();
    }

    /// A frame, as the main_window makes it.
    void frame() {
        client.watch(watched(view, measure_view));
        client.begin_frame();
        const SessionSnapshot& session = client.session();
        std::vector<StepMeasures> measures;
        const bool new_run = player.take_measures(measures);
        history.take(measures, new_run);
        names.update(session.setup);
        fields.update(session, *view.shown, view.difference);
        view.range.follow(*view.shown, view.difference, fields.span(), ColourRange::at_once);
        backgrounds.clear();
        PanelContext context{ui.theme, client, view,  measure_view, files, history,
                             frames,   fields, names, tooltip,      log,   backgrounds};
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        layout = lay_out(ui.theme, field_shape(session, view), size.x, size.y,
                         view.lessons || view.labs.inspector.open);
        const Column& side = inspector_column(layout, view.lessons);
        view.labs.side = {side.x, side.width, view.lessons};
        ui.frame([&] {
            column("controls", layout.controls, [&] { draw_control_column(context); });
            ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
            column("field", layout.field, [&] { place = draw_field_area(context); });
            ImGui::PopStyleVar();
            column("measures", layout.measures, [&] {
                if (instead) return instead(context);
                draw_measure_column(context);
            });
            draw_labs(context);
            if (over) over(context);
            tooltip.end_frame();
        });
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

    HeadlessUi& ui;
    Player player;
    Notifications notifications;
    SessionClient client{player, notifications};
    ViewSettings view;
    MeasureView measure_view;
    FileRequests files;
    History history;
    FrameLog frames;
    LaneFields fields;
    LaneNames names;
    Tooltip tooltip;
    EventLog log;
    BackgroundRects backgrounds;
    Layout layout{};
    FieldViewports place;
    std::function<void(PanelContext&)> instead;  ///< of the measures
    std::function<void(PanelContext&)> over;     ///< draws what else is on screen

  private:
    template <class Draw>
    void column(const char* name, const Column& where, Draw&& draw) {
        ImGui::SetNextWindowPos({where.x, layout.top});
        ImGui::SetNextWindowSize({where.width, layout.height});
        ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
        draw();
        ImGui::End();
    }
};

}  // namespace whorl::app
