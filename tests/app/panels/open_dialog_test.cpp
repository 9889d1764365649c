// The dialog that opens runs stays until it has opened one.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "app/panels/dialogs.h"
#include "app/scenes/presets.h"
#include "app/window/file_service.h"
#include "tests/support/cut_text.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

struct OpenWindow : LanesWindow {
    explicit OpenWindow(HeadlessUi& headless) : LanesWindow(headless, {}) {
        after_frame = [this] { service.end_frame(0); };
    }
    bool says(const std::string& what) const { return DrawnText().all().find(what) != std::string::npos; }

    FileService service{features.services, client, measure_view};
    OpenDialog& dialog = features.open_dialog;
};

TEST(OpenDialog, StaysWithTheReasonUntilSomethingIsOpened) {
    HeadlessUi ui(1024, 768, 1);
    OpenWindow window(ui);
    window.files.ask_open = true;
    ASSERT_TRUE(window.eventually([&] { return window.files.dialog; }));
    window.dialog.type("nowhere.toml");
    window.files.enter = true;
    ASSERT_TRUE(window.eventually([&] { return !window.dialog.error().empty(); }));
    for (int frame = 0; frame < 3; ++frame) window.frame();
    EXPECT_TRUE(window.files.dialog);
    EXPECT_TRUE(window.says("nowhere.toml: there is no such file")) << window.dialog.error();
    EXPECT_TRUE(window.notifications.shown().empty()) << "it is said once";

    ImGui::ClearActiveID();  // the field that is typed into keeps its own text
    window.dialog.type(presets().back().key);
    window.files.enter = true;
    ASSERT_TRUE(window.eventually([&] { return !window.files.dialog; }));
    EXPECT_EQ(window.client.loaded(), presets().back().key);

    window.files.ask_open = true;
    ASSERT_TRUE(window.eventually([&] { return window.files.dialog; }));
    EXPECT_TRUE(window.dialog.error().empty());
    window.files.escape = true;
    EXPECT_TRUE(window.eventually([&] { return !window.files.dialog; }));
}

TEST(OpenDialog, WhatIsDroppedFailsWithANotice) {
    HeadlessUi ui(1024, 768, 1);
    OpenWindow window(ui);
    window.files.open = "nowhere.toml";
    EXPECT_TRUE(window.eventually([&] { return !window.notifications.shown().empty(); }));
    EXPECT_FALSE(window.files.dialog);
}

}  // namespace
}  // namespace whorl::app
