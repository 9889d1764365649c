#include "app/tutorial/tour.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace whorl::app {
namespace {

constexpr int settling_frames = 3;

constexpr const char* field[] = {"field"};
constexpr const char* transport[] = {"play", "step", "reset", "timeline"};
constexpr const char* schemes[] = {"panel=Lanes", "comparison", "panel=Schemes", "advector"};
constexpr const char* measures[] = {"tab=Plots", "tab=Table", "plot=Total smoke", "plot=Kinetic energy",
                                    "plot=Enstrophy"};
constexpr const char* lessons[] = {"lessons"};
constexpr const char* labs[] = {"panel=Labs", "lab=interpolation", "lab=stencil", "lab=slice",
                                "lab=inspector"};

constexpr TourStop stops[] = {
    {"Smoke to play with",
     "Drag in the field: smoke and heat go in, and the fluid is pulled along. A right drag only pushes, a "
     "drag with Shift builds a wall. The run goes on meanwhile: try it.",
     field, ""},
    {"A run of steps",
     "Space plays and pauses, a full stop takes one step, R begins anew. Drag the line below to go back to "
     "any step; it comes out the same, to the last bit.",
     transport, "Run"},
    {"The scheme",
     "The advector carries the smoke. Choose another one while it runs: it acts from the next step on. "
     "Compare sets several schemes side by side, under the same hand.",
     schemes, "Lanes"},
    {"What it costs",
     "Energy and enstrophy that bend down where nothing slows the flow are lost by the scheme, not by the "
     "fluid. That loss is numerical dissipation, and Whorl is about it.",
     measures, ""},
    {"Where to begin",
     "Lessons walk through it, each step with a run to play with: from what advection is to what a scheme "
     "pays for its sharpness. Your own run comes back when you close them. Key: L",
     lessons, ""},
    {"Look inside",
     "The labs show how schemes work. Press I and click a cell to see the sum that made its value. H shows "
     "all keys, and this tour again.",
     labs, "Labs"},
};

}  // namespace

std::span<const TourStop> tour_stops() {
    return stops;
}

void Tour::begin() {
    running_ = true;
    ended_ = false;
    enter(0);
}

void Tour::next() {
    if (!running_) return;
    if (last()) return skip();
    enter(place_ + 1);
}

void Tour::back() {
    if (running_ && !first()) enter(place_ - 1);
}

void Tour::skip() {
    ended_ = ended_ || running_;
    back_up_ = back_up_ || running_;
    running_ = false;
}

void Tour::enter(std::size_t place) {
    place_ = place;
    unsettled_ = settling_frames;
    under_pointer_ = false;
}

void Tour::drawn(bool under_pointer) {
    under_pointer_ = under_pointer;
    if (unsettled_ > 0) --unsettled_;
}

bool Tour::take(const InputEvent& event) {
    if (!running_ || event.kind != InputEvent::Kind::Key) return false;
    void (Tour::*act)() = nullptr;
    switch (event.code) {
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER:
        case GLFW_KEY_RIGHT:
            act = &Tour::next;
            break;
        case GLFW_KEY_LEFT:
            act = &Tour::back;
            break;
        case GLFW_KEY_ESCAPE:
            act = &Tour::skip;
            break;
        default:
            return false;
    }
    if (!event.repeated) (this->*act)();
    return true;
}

}  // namespace whorl::app
