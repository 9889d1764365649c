// The tour: its steps, where its cards go, and that it is remembered.
#include "app/tutorial/tour.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include "app/scenes/presets.h"
#include "app/tutorial/tour_card.h"
#include "app/tutorial/tour_memory.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

namespace fs = std::filesystem;

bool press(Tour& tour, int key, bool repeated = false) {
    return tour.take({.kind = InputEvent::Kind::Key, .code = key, .repeated = repeated});
}

TEST(Tour, GoesOnAndBackByKeys) {
    Tour tour;
    EXPECT_FALSE(press(tour, GLFW_KEY_ENTER)) << "it has not begun";
    tour.begin();
    EXPECT_TRUE(tour.running());
    EXPECT_TRUE(tour.first());
    EXPECT_TRUE(press(tour, GLFW_KEY_LEFT));
    EXPECT_EQ(tour.place(), 0u);
    EXPECT_TRUE(press(tour, GLFW_KEY_RIGHT));
    EXPECT_TRUE(press(tour, GLFW_KEY_ENTER));
    EXPECT_EQ(tour.place(), 2u);
    EXPECT_TRUE(press(tour, GLFW_KEY_ENTER, true)) << "a key that is held is its key all the same";
    EXPECT_EQ(tour.place(), 2u);
    EXPECT_TRUE(press(tour, GLFW_KEY_LEFT));
    EXPECT_EQ(tour.place(), 1u);
    EXPECT_FALSE(press(tour, GLFW_KEY_SPACE)) << "the run's";
    EXPECT_FALSE(tour.take_ended());
}

TEST(Tour, EndsOnceAfterTheLastCardOrWhenSkipped) {
    Tour tour;
    tour.begin();
    for (std::size_t k = 0; k < tour_stops().size(); ++k) {
        EXPECT_TRUE(tour.running());
        tour.next();
    }
    EXPECT_FALSE(tour.running());
    EXPECT_TRUE(tour.take_ended());
    EXPECT_FALSE(tour.take_ended());
    tour.begin();
    EXPECT_EQ(tour.place(), 0u);
    tour.next();
    EXPECT_TRUE(press(tour, GLFW_KEY_ESCAPE));
    EXPECT_FALSE(tour.running());
    EXPECT_TRUE(tour.take_ended());
    tour.skip();
    EXPECT_FALSE(tour.take_ended()) << "it was not running";
}

RC_GTEST_PROP(TourCard, IsOnTheScreenAndBesideItsTargetWhereThereIsRoom, ()) {
    const auto between = [](int low, int high) { return static_cast<float>(*rc::gen::inRange(low, high)); };
    const ImVec2 screen{between(700, 2000), between(500, 1600)};
    const ImVec2 card{between(200, 400), between(100, 300)};
    const float gap = between(0, 20);
    const ScreenBox target = [&] {
        const ImVec2 low{between(0, 600), between(0, 400)};
        return ScreenBox{low, {low.x + between(1, 1500), low.y + between(1, 1200)}};
    }();
    const ImVec2 at = card_corner(target, card, screen, gap);
    RC_ASSERT(at.x >= gap);
    RC_ASSERT(at.y >= gap);
    RC_ASSERT(at.x + card.x <= screen.x - gap);
    RC_ASSERT(at.y + card.y <= screen.y - gap);
    const bool beside = at.x >= target.high.x || at.x + card.x <= target.low.x || at.y >= target.high.y ||
                        at.y + card.y <= target.low.y;
    const float room_x = std::max(target.low.x, screen.x - target.high.x);
    const float room_y = std::max(target.low.y, screen.y - target.high.y);
    // Corners are whole pixels.
    constexpr float rounding = 1;
    if (room_x >= card.x + 2 * gap + rounding || room_y >= card.y + 2 * gap + rounding) RC_ASSERT(beside);
}

/// The window with the tour in it.
struct TourWindow : LanesWindow {
    using LanesWindow::LanesWindow;

    void frames_of_tour(int count) {
        for (int k = 0; k < count; ++k) frame();
    }
    std::optional<ControlRect> card() const {
        return log.rects().in_sight("tour-card=" + std::to_string(features.tour.place() + 1));
    }
};

Recording small_plume(std::size_t lanes) {
    Recording run{.setup = {.scene = presets().front().scene()}};
    run.setup.scene.resolution = 16;
    run.setup.lanes = std::vector<LaneSetup>(lanes);
    return run;
}

constexpr int settled = 8;  // frames: a panel opens, then it is scrolled to

TEST(TourCard, FindsWhatItSpeaksOfInEveryWindow) {
    struct Size {
        int width, height;
        float scale;
    };
    for (const Size size :
         {Size{1600, 1000, 1}, Size{1024, 768, 1}, Size{900, 600, 1}, Size{2048, 1536, 2}}) {
        HeadlessUi ui(size.width, size.height, size.scale);
        for (const std::size_t lanes : {1u, 6u}) {
            TourWindow window(ui, small_plume(lanes));
            window.features.tour.begin();
            for (std::size_t k = 0; k < tour_stops().size(); ++k) {
                SCOPED_TRACE("card " + std::to_string(k + 1) + " at " + std::to_string(size.width) + ", " +
                             std::to_string(lanes) + " lanes");
                window.frames_of_tour(settled);
                const auto target = target_of(window.features.tour.stop(), window.log.rects());
                ASSERT_TRUE(target);
                const auto card = window.card();
                ASSERT_TRUE(card);
                EXPECT_GE(card->x, 0);
                EXPECT_GE(card->y, 0);
                EXPECT_LE(card->x + card->width, static_cast<float>(size.width));
                EXPECT_LE(card->y + card->height, static_cast<float>(size.height));
                // What is on the card lies within it.
                const ImGuiWindow* drawn = ImGui::FindWindowByName("tour");
                EXPECT_LE(drawn->ContentSize.x, drawn->InnerRect.GetWidth() - 2 * drawn->WindowPadding.x);
                EXPECT_LE(drawn->ContentSize.y, drawn->InnerRect.GetHeight() - 2 * drawn->WindowPadding.y);
                if (std::string_view(window.features.tour.stop().panel) == "Labs") {
                    EXPECT_TRUE(window.log.rects().in_sight("lab=interpolation"));
                }
                window.features.tour.next();
            }
            EXPECT_FALSE(window.features.tour.running());
        }
    }
}

TEST(TourCard, IsUsedWithTheMouseWhileTheRunGoesOn) {
    HeadlessUi ui(1024, 768, 1);
    TourWindow window(ui, small_plume(1));
    window.player.play(true);
    window.features.tour.begin();
    window.frames_of_tour(settled);
    const auto middle = [&](const char* key) {
        const ControlRect place = window.log.rects().in_sight(key).value();
        return ImVec2{place.x + 0.5f * place.width, place.y + 0.5f * place.height};
    };
    window.click(middle("tour-next"));
    EXPECT_EQ(window.features.tour.place(), 1u);
    window.frames_of_tour(settled);
    window.click(middle("tour-back"));
    EXPECT_EQ(window.features.tour.place(), 0u);
    window.frames_of_tour(settled);
    EXPECT_FALSE(window.place.covered);
    ImGui::GetIO().MousePos = middle("tour-card=1");
    window.frames_of_tour(2);
    EXPECT_TRUE(window.place.covered) << "a click on the card is no stroke";
    const long step = window.client.session().step;
    EXPECT_TRUE(window.eventually([&] {
        window.player.begin_frame();
        return window.client.session().step > step + 3;
    }));
    window.click(middle("tour-skip"));
    EXPECT_FALSE(window.features.tour.running());
    window.frames_of_tour(2);
    EXPECT_FALSE(window.card());
    EXPECT_FALSE(window.place.covered);
}

TEST(TourCard, LeavesTheLeftColumnAtItsHead) {
    HeadlessUi ui(1024, 768, 1);
    TourWindow window(ui, small_plume(1));
    window.features.tour.begin();
    while (!window.features.tour.last()) {
        window.frames_of_tour(settled);
        window.features.tour.next();
    }
    window.frames_of_tour(settled);
    ASSERT_FALSE(window.log.rects().in_sight("play")) << "the last card is about what stands below";
    window.features.tour.next();
    window.frames_of_tour(settled);
    EXPECT_TRUE(window.log.rects().in_sight("play"));
}

TEST(TourCard, StepsAsideForTheHelpWhichBringsItBack) {
    HeadlessUi ui(1024, 768, 1);
    TourWindow window(ui, small_plume(1));
    window.features.tour.begin();
    window.features.tour.next();
    window.frames_of_tour(settled);
    window.features.help.open = true;
    EXPECT_FALSE(window.features.tour_in_sight());
    window.frames_of_tour(settled);
    EXPECT_FALSE(window.card());
    const ControlRect button = window.log.rects().in_sight("help-tour").value();
    window.click({button.x + 0.5f * button.width, button.y + 0.5f * button.height});
    EXPECT_FALSE(window.features.help.open);
    EXPECT_TRUE(window.features.tour.running());
    EXPECT_EQ(window.features.tour.place(), 0u);
    window.frames_of_tour(2);
    EXPECT_TRUE(window.card());
}

/// A folder of its own as $XDG_STATE_HOME.
class TourMemory : public testing::Test {
  protected:
    void SetUp() override { set("XDG_STATE_HOME", folder_); }
    void TearDown() override {
        fs::remove_all(folder_);
        for (const auto& [name, value] : before_) {
            if (value) {
                ::setenv(name.c_str(), value->c_str(), 1);
            } else {
                ::unsetenv(name.c_str());
            }
        }
    }
    void set(const std::string& name, const std::string& value) {
        const char* before = std::getenv(name.c_str());
        before_.try_emplace(name, before != nullptr ? std::optional<std::string>(before) : std::nullopt);
        ::setenv(name.c_str(), value.c_str(), 1);
    }
    const std::string folder_ = testing::TempDir() + "tour-" + std::to_string(::getpid());

  private:
    std::map<std::string, std::optional<std::string>> before_;
};

TEST_F(TourMemory, IsAnEmptyFile) {
    EXPECT_EQ(tour_memory(), fs::path(folder_) / "whorl" / "tour-seen");
    EXPECT_FALSE(tour_seen());
    remember_tour();
    EXPECT_TRUE(tour_seen());
    EXPECT_EQ(fs::file_size(tour_memory()), 0u);
    remember_tour();
    EXPECT_TRUE(tour_seen());
}

TEST_F(TourMemory, IsAtHomeWithoutAStateFolder) {
    set("HOME", folder_);
    set("XDG_STATE_HOME", "");
    EXPECT_EQ(tour_memory(), fs::path(folder_) / ".local/state/whorl/tour-seen");
    set("XDG_STATE_HOME", "not/absolute");
    EXPECT_EQ(tour_memory(), fs::path(folder_) / ".local/state/whorl/tour-seen");
    set("HOME", "");
    EXPECT_TRUE(tour_memory().empty());
    EXPECT_FALSE(tour_seen());
    EXPECT_THROW(remember_tour(), std::runtime_error);
}

TEST_F(TourMemory, SaysWhyItCannotBeWritten) {
    std::ofstream(folder_) << "a file where a folder would be";
    EXPECT_FALSE(tour_seen());
    EXPECT_THROW(remember_tour(), std::runtime_error);
}

}  // namespace
}  // namespace whorl::app
