#include "app/panels/remote.h"

#include <algorithm>
#include <numeric>

#include "core/scene/error.h"

namespace whorl::app {
namespace {

/// "velocity.", "scalars." or nothing: which scheme set a key belongs to.
std::string prefix_of(std::string_view key) {
    const std::size_t dot = key.find('.');
    return dot == std::string_view::npos ? std::string() : std::string(key.substr(0, dot + 1));
}

void act(const Command& command, Setup& setup) {
    if (const auto* edit = std::get_if<SetParameter>(&command)) {
        set_parameter(setup.scene, edit->key, edit->value);
    } else if (const auto* other = std::get_if<Arrange>(&command)) {
        setup.lanes = other->lanes;
        setup.reference = other->reference;
    }
}

std::string label_of(const Parameter& p, double value) {
    return p.kind == Parameter::Kind::Choice ? std::string(p.choices[static_cast<std::size_t>(value)].label)
                                             : p.label;
}

}  // namespace

void Remote::begin_frame() {
    session_ = &player_.newest();
    if (std::string complaint = player_.take_complaint(); !complaint.empty()) {
        notices_.warn(std::move(complaint));
    }
    settle();
}

void Remote::settle() {
    while (!pending_.empty() && pending_.front().ticket <= session_->taken) pending_.pop_front();
    setup_ = session_->setup;
    for (const Pending& p : pending_) act(p.command, setup_);
    choose_scene();
}

/// A lane that was just removed or whose edit is refused has no scene: then that of all.
void Remote::choose_scene() {
    scene_ = setup_.scene;
    if (!lane_only_ || selected() >= setup_.lanes.size()) return;
    try {
        scene_ = lane_scene(setup_.scene, setup_.lanes[selected()]);
    } catch (const InputError&) {
        scene_ = snapshot().scene;
    }
}

std::size_t Remote::selected() const {
    const auto found = std::find(session_->ids.begin(), session_->ids.end(), selected_id_);
    return found == session_->ids.end() ? 0 : static_cast<std::size_t>(found - session_->ids.begin());
}

void Remote::select(std::size_t lane) {
    selected_id_ = session_->ids[lane];
    choose_scene();
}

void Remote::set_lane_only(bool lane_only) {
    lane_only_ = lane_only;
    choose_scene();
}

void Remote::push(Command command) {
    const std::uint64_t ticket = player_.push(command);
    if (std::holds_alternative<SetParameter>(command) || std::holds_alternative<Arrange>(command))
        pending_.push_back({ticket, std::move(command)});
}

Scene Remote::with(const Parameter& p, double value) const {
    Scene wanted = scene_;
    p.set(wanted, value);
    return wanted;
}

void Remote::push_edit(const Parameter& p, double value) {
    SetParameter edit{p.key, p.text(value)};
    if (lane_only_ && selected() < setup_.lanes.size()) {
        Arrange changed{setup_.lanes, std::vector<int>(setup_.lanes.size()), setup_.reference};
        std::iota(changed.from.begin(), changed.from.end(), 0);
        changed.lanes[selected()].set(std::move(edit));
        push(std::move(changed));
    } else {
        push(std::move(edit));
    }
    act(pending_.back().command, setup_);
    choose_scene();
}

void Remote::set(const Parameter& p, double value) {
    try {
        p.check(value);
    } catch (const InputError& e) {
        notices_.warn(e.what());
        return;
    }
    if (!conflict(with(p, value)).empty()) {
        // A scheme that needs linear sampling brings it along; anything else is the run's to refuse.
        const Parameter& interpolation = parameter(prefix_of(p.key) + "interpolation");
        const double linear = interpolation.parse(Linear::info.key);
        const double before = interpolation.get(scene_);
        Scene both = with(p, value);
        interpolation.set(both, linear);
        if (&p != &interpolation && conflict(both).empty()) {
            push_edit(interpolation, linear);
            notices_.info(interpolation.label + " is now " + label_of(interpolation, linear) + " (was " +
                          label_of(interpolation, before) + "): " + label_of(p, value) +
                          " takes values and gradients from linear weights [thesis eq. 4.2–4.3]");
        }
    }
    push_edit(p, value);
}

bool Remote::overridden(const Parameter& p) const {
    if (selected() >= setup_.lanes.size()) return false;
    const auto& overrides = setup_.lanes[selected()].overrides;
    return std::any_of(overrides.begin(), overrides.end(),
                       [&](const SetParameter& o) { return o.key == p.key; });
}

void Remote::arrange(Arrange arrange) {
    try {
        lane_scenes({setup_.scene, arrange.lanes, arrange.reference});
        push(std::move(arrange));
    } catch (const InputError& e) {
        notices_.warn(e.what());
    }
}

void Remote::load(std::string_view key, Recording recording) {
    try {
        player_.load(std::move(recording));
        loaded_ = key;
        pending_.clear();
        lane_only_ = false;
    } catch (const InputError& e) {
        notices_.warn(e.what());
    }
}

void Remote::set_pace(Pace pace) {
    pace_ = pace;
    player_.set_pace(pace);
}

}  // namespace whorl::app
