#include "app/run/session_client.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"

namespace whorl::app {
namespace {

/// "velocity.", "scalars." or nothing: which scheme set a key belongs to.
std::string_view prefix_of(std::string_view key) {
    const std::size_t dot = key.find('.');
    return dot == std::string_view::npos ? std::string_view() : key.substr(0, dot + 1);
}

/// The key without the set of schemes that it belongs to.
std::string_view bare(std::string_view key) {
    return key.substr(prefix_of(key).size());
}

/// Whether two keys stand for the same value of a scheme set: one of both, or of the same one.
bool meet(std::string_view a, std::string_view b) {
    if (a == b) return true;
    return bare(a) == bare(b) && (bare(a) == a || bare(b) == b);
}

std::size_t place_of(int id, const std::vector<int>& ids, std::size_t otherwise) {
    const auto found = std::find(ids.begin(), ids.end(), id);
    return found == ids.end() ? otherwise : static_cast<std::size_t>(found - ids.begin());
}

std::string label_of(const Parameter& p, double value) {
    return p.kind == Parameter::Kind::Choice ? std::string(p.choices[static_cast<std::size_t>(value)].label)
                                             : p.label;
}

}  // namespace

void SessionClient::begin_frame() {
    const int run = session_ != nullptr ? session_->run : 0;
    const std::size_t place = session_ != nullptr ? selected() : 0;
    const std::size_t before = session_ != nullptr ? other() : 0;
    // First: where nothing is sought any more, the newest snapshot shows it.
    sought_ = player_.sought();
    session_ = &player_.newest();
    if (session_->run != run) {
        // Another run numbers its lanes anew: what was selected stays by its place.
        const auto id_at = [&](std::size_t k) {
            return k < session_->ids.size() ? session_->ids[k] : unknown;
        };
        selected_id_ = id_at(place);
        previous_id_ = id_at(before);
    }
    if (std::string complaint = player_.take_complaint(); !complaint.empty()) {
        notifications_.warn(std::move(complaint));
    }
    settle();
}

void SessionClient::settle() {
    while (!pending_.empty() && pending_.front().ticket <= session_->taken) pending_.pop_front();
    if (to_select_ && to_select_->first <= session_->taken) {
        if (to_select_->second < session_->ids.size()) select_id(session_->ids[to_select_->second]);
        to_select_.reset();
    }
    setup_ = session_->setup;
    ids_ = session_->ids;
    for (const Pending& p : pending_) act(p.command);
    if (setup_.lanes.size() == 1) lane_only_ = false;
    choose_scene();
}

/// What a command will make of scene and lanes.
void SessionClient::act(const Command& command) {
    if (const auto* edit = std::get_if<SetParameter>(&command)) {
        set_parameter(setup_.scene, edit->key, edit->value);
    } else if (const auto* other = std::get_if<Arrange>(&command)) {
        std::vector<int> ids;
        for (const int from : other->from) {
            const int id = from < static_cast<int>(ids_.size()) ? ids_[from] : unknown;
            ids.push_back(std::find(ids.begin(), ids.end(), id) == ids.end() ? id : unknown);
        }
        ids_ = std::move(ids);
        setup_.lanes = other->lanes;
        setup_.reference = other->reference;
    }
}

/// A lane whose edit is refused has no scene: then that of all.
void SessionClient::choose_scene() {
    scene_ = setup_.scene;
    if (!lane_only_) return;
    try {
        scene_ = lane_scene(setup_.scene, setup_.lanes[selected_in_setup()]);
    } catch (const InputError&) {
        scene_ = snapshot().scene;
    }
}

std::size_t SessionClient::selected() const {
    return place_of(selected_id_, session_->ids, 0);
}

std::size_t SessionClient::selected_in_setup() const {
    return place_of(selected_id_, ids_, 0);
}

std::size_t SessionClient::other() const {
    const std::size_t next = (selected() + 1) % session_->lanes.size();
    const std::size_t before = place_of(previous_id_, session_->ids, next);
    return before == selected() ? next : before;
}

void SessionClient::select_id(int id) {
    if (id == unknown || id == selected_id_) return;
    previous_id_ = selected_id_;
    selected_id_ = id;
    choose_scene();
}

void SessionClient::set_lane_only(bool lane_only) {
    lane_only_ = lane_only;
    choose_scene();
}

void SessionClient::push(Command command) {
    const std::uint64_t ticket = player_.push(command);
    if (std::holds_alternative<SetParameter>(command) || std::holds_alternative<Arrange>(command))
        pending_.push_back({ticket, std::move(command)});
}

Scene SessionClient::with(const Parameter& p, double value) const {
    Scene wanted = scene_;
    p.set(wanted, value);
    return wanted;
}

void SessionClient::push_edit(const Parameter& p, double value) {
    SetParameter edit{p.key, p.text(value)};
    // The brush is the hand's, and the same in all lanes.
    if (lane_only_ && p.group != Parameter::Group::Brush) {
        Arrange changed = arrangement();
        changed.lanes[selected_in_setup()].set(std::move(edit));
        push(std::move(changed));
    } else {
        push(std::move(edit));
    }
    act(pending_.back().command);
    choose_scene();
}

void SessionClient::set(const Parameter& p, double value) {
    try {
        p.check(value);
    } catch (const InputError& e) {
        notifications_.warn(e.what());
        return;
    }
    if (!conflict(with(p, value)).empty()) {
        // A scheme that needs linear sampling brings it along; anything else is the run's to refuse.
        const Parameter& interpolation = parameter(std::string(prefix_of(p.key)) + "interpolation");
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

bool SessionClient::overridden(const Parameter& p, std::size_t lane) const {
    const auto& overrides = setup_.lanes[lane].overrides;
    return std::any_of(overrides.begin(), overrides.end(),
                       [&](const SetParameter& o) { return meet(o.key, p.key); });
}

void SessionClient::drop_overrides(const Parameter& p) {
    Arrange changed = arrangement();
    for (std::size_t k = 0; k < changed.lanes.size(); ++k) {
        if (lane_only_ && k != selected_in_setup()) continue;
        std::erase_if(changed.lanes[k].overrides, [&](const SetParameter& o) { return meet(o.key, p.key); });
    }
    if (changed.lanes != setup_.lanes) arrange(std::move(changed));
}

Arrange SessionClient::arrangement() const {
    Arrange same{setup_.lanes, std::vector<int>(setup_.lanes.size()), setup_.reference};
    std::iota(same.from.begin(), same.from.end(), 0);
    return same;
}

bool SessionClient::arrange(Arrange arrange, std::optional<std::size_t> select) {
    try {
        lane_scenes({setup_.scene, arrange.lanes, arrange.reference});
    } catch (const InputError& e) {
        notifications_.warn(e.what());
        return false;
    }
    push(std::move(arrange));
    act(pending_.back().command);
    if (select) to_select_ = {pending_.back().ticket, *select};
    choose_scene();
    return true;
}

void SessionClient::load(std::string_view key, Recording recording, bool set_aside) {
    try {
        const long step = recording.step;
        player_.load(std::move(recording), set_aside);
        sought_ = step;
        ++loads_;
        loaded_ = key;
        pending_.clear();
        to_select_.reset();
        lane_only_ = false;
    } catch (const InputError& e) {
        notifications_.warn(e.what());
    }
}

void SessionClient::load_scene(std::string_view key, const Scene& scene) {
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

void SessionClient::set_pace(Pace pace) {
    pace_ = pace;
    player_.set_pace(pace);
}

}  // namespace whorl::app
