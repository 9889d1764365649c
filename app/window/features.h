// The parts of the window, made from the lists, and what they share.
#pragma once

#include <vector>

#include "app/charts/measure_column.h"
#include "app/inspector/inspection.h"
#include "app/panels/control_column.h"
#include "app/panels/dialogs.h"
#include "app/panels/field_area.h"
#include "app/run/field_layers.h"
#include "app/run/history.h"
#include "app/run/lab_windows.h"
#include "app/run/right_column.h"
#include "app/run/session_client.h"
#include "app/run/shared_state.h"
#include "app/tutorial/help_overlay.h"
#include "app/tutorial/lesson_panel.h"
#include "app/tutorial/tour_card.h"
#include "app/window/layout.h"

namespace whorl::app {

/// All that is drawn in the window but the fields' pixels, and all that takes input. Needs an ImGui context,
/// and makes no assumption about where its events come from.
class Features {
  public:
    /// @param player  plays the run that is shown
    Features(const Theme& theme, Player& player, EventLog& log, Notifications& notifications);
    Features(const Features&) = delete;
    Features& operator=(const Features&) = delete;

    /// Takes the newest state, its measures, and what is shown of it with its range; call once a frame,
    /// first.
    /// @param seconds  since the last call, see ColourRange
    void begin_frame(double seconds);
    /// Calls on whoever an event is meant for.
    void take(const InputEvent& event);
    /// Ends what takes input in a frame, after its events.
    void end_input();
    /// Draws an ImGui frame. @param width pixels  @param height pixels
    void draw(float width, float height);

    /// Whether the tour's card is drawn, and takes keys: it steps aside for the help and the dialogs.
    bool tour_in_sight() const { return tour.running() && !help.open && !files.dialog; }
    const Inspection& inspection() { return shared.of<Inspection>(); }

    // Services.
    Ui ui;
    SessionClient run;
    ViewSettings view;
    LaneFields fields;
    History history;
    FrameLog frames;
    FileRequests files;
    RightColumn right_column;
    LabWindows labs;
    SharedState shared;
    const Services services;

    // Parts.
    FieldLayers layers;
    ControlColumn controls;
    FieldArea field_area;
    MeasureView measures;
    MeasureColumn measure_column;
    LessonPlayer lessons;
    LessonPanel lesson_panel;
    Tour tour;
    TourCard tour_card;
    HelpOverlay help;
    OpenDialog open_dialog;
    FilmDialog film_dialog;

    Layout layout{};           ///< of the last frame
    FieldViewports viewports;  ///< in it
    bool list_open = false;    ///< a list that a control has opened lay over it
    bool closes = false;       ///< the window is to be closed

  private:
    void draw_measures();
    void note_keys();

    Player& player_;
    std::vector<StepMeasures> step_measures_;
    std::vector<KeyHelp> mouse_help_, key_help_;
};

}  // namespace whorl::app
