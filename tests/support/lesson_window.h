// The lessons' panel in a column of its own, drawn without a display.
#pragma once

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "app/run/session_client.h"
#include "app/tutorial/lesson_panel.h"
#include "app/ui/wrapped_text.h"
#include "app/views/lane_fields.h"
#include "tests/support/eventually.h"
#include "tests/support/headless_ui.h"

namespace whorl::app {

/// A column of the panel's least width at the right of the screen, as frames of the window draw it.
struct LessonWindow {
    explicit LessonWindow(HeadlessUi& headless) : ui(headless) { client.begin_frame(); }

    void frame() {
        player.begin_frame();
        client.begin_frame();
        const SessionSnapshot& session = client.session();
        // As the window does: it must not take away what a step asks for.
        if (!available(*view.shown, client.snapshot())) view.shown = views().front();
        if (session.lanes.size() == 1) {
            view.compare = Compare::SideBySide;
            view.difference = false;
        }
        fields.update(session, *view.shown, view.difference);
        panel_ui.backgrounds.clear();
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        const float width = ui.theme.px(lesson_column_width);
        const float margin = ui.theme.px(8);
        ui.frame([&] {
            ImGui::SetNextWindowPos({screen.x - width - margin, margin});
            ImGui::SetNextWindowSize({width, screen.y - 2 * margin});
            ImGui::Begin("lessons", nullptr,
                         ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
            panel.draw();
            column = ImGui::GetCurrentWindow()->Rect();
            ImGui::End();
            panel_ui.tooltip.end_frame();
        });
    }
    template <class IsSo>
    bool eventually(IsSo&& is_so) {
        return whorl::eventually([&] {
            frame();
            return is_so();
        });
    }
    void press(int key) {
        EXPECT_TRUE(lesson_player.take({.kind = InputEvent::Kind::Key, .code = key}));
        frame();
    }
    /// Clicks a control by its name in the event log.
    void click(const char* key) {
        const auto place = log.rects().in_sight(key);
        ASSERT_TRUE(place) << key;
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = {place->x + 0.5f * place->width, place->y + 0.5f * place->height};
        for (const bool down : {false, true, false}) {
            io.MouseDown[0] = down;
            frame();
        }
        io.MousePos = {-FLT_MAX, -FLT_MAX};
        frame();
    }
    /// Whether everything is as the step says.
    bool shows(const LessonStep& step) const {
        const Compare compare = step.mode == LessonMode::One    ? Compare::One
                                : step.mode == LessonMode::Wipe ? Compare::Wipe
                                                                : Compare::SideBySide;
        return client.session().setup == step.recording.setup &&
               client.session().step == step.recording.step && view.shown == step.view &&
               view.compare == compare && view.difference == (step.mode == LessonMode::Difference) &&
               !client.playing();
    }

    HeadlessUi& ui;
    Player player{{.setup = {}}, 1};
    Notifications notifications;
    SessionClient client{player, notifications};
    ViewSettings view;
    LaneFields fields;
    EventLog log{""};
    Ui panel_ui{ui.theme, log, notifications};
    LessonPlayer lesson_player{client, view};
    RightColumn right_column;
    LessonPanel panel{panel_ui, lesson_player, right_column};
    ImRect column;
};

}  // namespace whorl::app
