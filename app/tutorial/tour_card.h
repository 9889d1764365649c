// Draws the tour's card beside what it speaks of.
#pragma once

#include <imgui.h>

#include <optional>

#include "app/tutorial/tour.h"
#include "app/ui/ui.h"

namespace whorl::app {

/// A rectangle on screen, pixels.
struct ScreenBox {
    ImVec2 low, high;
};

/// Where a card goes: beside its target without covering it, where the screen has room; else on the target's
/// lower part, as a field that fills the window has none beside it. Always within the screen.
/// @param gap  between card and target, and to the edges of the screen
ImVec2 card_corner(const ScreenBox& target, ImVec2 card, ImVec2 screen, float gap);

/// What of the card's targets is in sight, as one rectangle; nothing if none of them is.
std::optional<ScreenBox> target_of(const TourStop& stop, const ControlRects& places);

/// Draws the card over everything that is not a list or a dialog, and a ring around what it speaks of.
class TourCard {
  public:
    TourCard(Ui& ui, Tour& tour) : ui_(ui), tour_(tour) {}

    void draw();

  private:
    /// Skip at the left, the way back and on at the right.
    void draw_buttons();

    Ui& ui_;
    Tour& tour_;
};

}  // namespace whorl::app
