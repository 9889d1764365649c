#include "app/run/run_control.h"

#include <algorithm>

#include "core/base/error.h"

namespace whorl::app {
namespace {

std::string label_of(const Parameter& p, double value) {
    return p.kind == Parameter::Kind::Choice ? std::string(p.choices[static_cast<std::size_t>(value)].label)
                                             : p.label;
}

}  // namespace

void RunControl::select_id(int id) {
    if (id == unknown || id == selected_id_) return;
    previous_id_ = selected_id_;
    selected_id_ = id;
    choose_scene();
}

void RunControl::set_lane_only(bool lane_only) {
    lane_only_ = lane_only;
    choose_scene();
}

void RunControl::push(Command command) {
    const std::uint64_t ticket = player_.push(command);
    if (std::holds_alternative<SetParameter>(command) || std::holds_alternative<Arrange>(command))
        pending_.push_back({ticket, std::move(command)});
}

Scene RunControl::with(const Parameter& p, double value) const {
    Scene wanted = scene_;
    p.set(wanted, value);
    return wanted;
}

void RunControl::push_edit(const Parameter& p, double value) {
    SetParameter edit{p.key, p.text(value)};
    // The brush is the hand's, and the same in all lanes.
    if (lane_only_ && p.group != Parameter::Group::Brush) {
        Arrange changed = arrangement();
        changed.lanes[selected_in_setup()].set(std::move(edit));
        push(std::move(changed));
    } else {
        push(std::move(edit));
    }
    foresee(pending_.back().command);
    choose_scene();
}

void RunControl::set(const Parameter& p, double value) {
    try {
        p.check(value);
    } catch (const InputError& e) {
        notifications_.warn(e.what());
        return;
    }
    if (!conflict(with(p, value)).empty()) {
        // A scheme that needs linear sampling brings it along; anything else is the run's to refuse.
        const Parameter& interpolation = parameter(std::string(scheme_set_prefix(p.key)) + "interpolation");
        const double linear = interpolation.parse(whorl::linear.info.key);
        const double before = interpolation.get(scene_);
        Scene both = with(p, value);
        interpolation.set(both, linear);
        if (&p != &interpolation && conflict(both).empty()) {
            push_edit(interpolation, linear);
            notifications_.info(interpolation.label + " is now " + label_of(interpolation, linear) +
                                " (was " + label_of(interpolation, before) + "): " + label_of(p, value) +
                                " takes values and gradients from linear weights [thesis eq. 4.2–4.3]");
        }
    }
    push_edit(p, value);
}

void RunControl::drop_overrides(const Parameter& p) {
    Arrange changed = arrangement();
    for (std::size_t k = 0; k < changed.lanes.size(); ++k) {
        if (lane_only_ && k != selected_in_setup()) continue;
        std::erase_if(changed.lanes[k].overrides,
                      [&](const SetParameter& o) { return same_parameter(o.key, p.key); });
    }
    if (changed.lanes != setup_.lanes) arrange(std::move(changed));
}

bool RunControl::arrange(Arrange arrange, std::optional<std::size_t> select) {
    try {
        lane_scenes({setup_.scene, arrange.lanes, arrange.reference});
    } catch (const InputError& e) {
        notifications_.warn(e.what());
        return false;
    }
    push(std::move(arrange));
    foresee(pending_.back().command);
    if (select) to_select_ = {pending_.back().ticket, *select};
    choose_scene();
    return true;
}

void RunControl::load(std::string_view key, Recording recording, bool stash) {
    try {
        const long step = recording.step;
        player_.load(std::move(recording), stash);
        seek_target_ = step;
        ++loads_;
        loaded_ = key;
        pending_.clear();
        to_select_.reset();
        lane_only_ = false;
    } catch (const InputError& e) {
        notifications_.warn(e.what());
    }
}

void RunControl::load_scene(std::string_view key, const Scene& scene) {
    if (setup_.lanes.size() == 1) return load(key, {.setup = {.scene = scene}});
    const Setup compared{scene, setup_.lanes, setup_.reference};
    const std::size_t place = selected_in_setup();
    try {
        lane_scenes(compared);
        load(key, {.setup = compared});
        selected_id_ = static_cast<int>(place);  // a session numbers its first lanes in their order
    } catch (const InputError& e) {
        notifications_.info("The lanes do not go with this scene, which begins with one: " +
                            std::string(e.what()));
        load(key, {.setup = {.scene = scene}});
    }
}

void RunControl::set_pace(Pace pace) {
    pace_ = pace;
    player_.set_pace(pace);
}

void RunControl::move_by(long by) {
    const SessionSnapshot& shown = session();
    const long from = seek_target().value_or(shown.step);
    if (by > 0 && from >= shown.last_step) {
        step();
    } else {
        seek(std::max(0L, from + by));
    }
}

}  // namespace whorl::app
