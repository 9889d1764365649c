// A newcomer's way around the window: which card of it is shown.
#pragma once

#include <span>
#include <string_view>
#include <utility>

#include "app/ui/input_event.h"

namespace whorl::app {

/// A card of the tour.
struct TourStop {
    const char* title;
    const char* text;
    std::span<const char* const> targets;  ///< controls that it speaks of, by their names in the event log
    std::string_view panel;                ///< the left column's that it speaks of; empty for none
};

/// All cards, in order.
std::span<const TourStop> tour_stops();

/// A card at a time, until the last one is done or the tour is skipped.
class Tour {
  public:
    bool running() const { return running_; }
    std::size_t place() const { return place_; }
    const TourStop& stop() const { return tour_stops()[place_]; }
    bool first() const { return place_ == 0; }
    bool last() const { return place_ + 1 == tour_stops().size(); }

    void begin();
    void next();
    void back();
    /// Ends the tour wherever it is.
    void skip();
    /// Enter and → go on, ← goes back, Esc skips.
    /// @return whether the event was one of them
    bool take(const InputEvent& event);

    /// Whether the tour has ended since the last call.
    bool take_ended() { return std::exchange(ended_, false); }
    /// The panel that is to be opened and brought into sight; for some frames after a card came up, as a
    /// panel that opens needs them. Empty if there is none.
    std::string_view wanted_panel() const { return running_ && unsettled_ > 0 ? stop().panel : ""; }

    /// Whether the left column is to go back to its head, once after the tour: the last cards are at its
    /// foot.
    bool take_back_up() { return std::exchange(back_up_, false); }

    // What its drawing leaves behind.
    void drawn(bool under_pointer);
    /// Whether the pointer is on the card: the field below it takes no strokes.
    bool under_pointer() const { return running_ && under_pointer_; }

  private:
    void enter(std::size_t place);

    bool running_ = false, ended_ = false, back_up_ = false, under_pointer_ = false;
    std::size_t place_ = 0;
    int unsettled_ = 0;
};

}  // namespace whorl::app
