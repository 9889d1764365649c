#include "core/session/session.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/error.h"
#include "core/scene/digest.h"
#include "core/scene/parameters.h"

namespace whorl {
namespace {

void fail_with(const std::string& reason) {
    if (!reason.empty()) throw InputError(reason);
}

}  // namespace

Session::Session(Recording recording, Pool& pool, std::size_t limit_bytes)
    : pool_(&pool), recorded_(std::move(recording)), last_step_(recorded_.step), kept_(limit_bytes) {
    begin();
}

/// The start of the recording, with nothing acted yet but the commands of step 0.
void Session::begin() {
    const std::vector<Scene> scenes = lane_scenes(recorded_.setup);
    setup_ = recorded_.setup;
    lanes_.clear();
    next_id_ = 0;
    for (const Scene& scene : scenes)
        lanes_.push_back({std::make_unique<Lane>(scene, *pool_), next_id_++, {}});
    step_ = 0;
    time_ = 0;
    acted_ = 0;
    observe();
    const std::string refusal = act_recorded();
    measure();
    fail_with(refusal);
}

void Session::step() {
    ++step_;
    time_ += setup_.scene.dt;
    for (LaneSlot& slot : lanes_) slot.lane->step_to(time_);
    observe();
    last_step_ = std::max(last_step_, step_);
    if (kept_.wants(step_)) kept_.keep(step_, checkpoint());
    const std::string refusal = act_recorded();
    measure();
    fail_with(refusal);
}

/// @return why one of the commands could not act; empty if all did
std::string Session::act_recorded() {
    std::string refusal;
    while (acted_ < recorded_.commands.size() && recorded_.commands[acted_].step <= step_) {
        try {
            act(recorded_.commands[acted_++].command);
        } catch (const InputError& e) {
            refusal = "step " + std::to_string(step_) + ": " + e.what();
        }
    }
    return refusal;
}

void Session::apply(const Command& command) {
    if (std::holds_alternative<Restart>(command)) {
        recorded_ = {.setup = setup_, .commands = {}, .step = 0};
        complete_ = true;
        last_step_ = 0;
        kept_.clear();
        begin();
        return;
    }
    act(command);
    measure();
    recorded_.commands.resize(acted_);
    kept_.forget_after(step_);
    last_step_ = step_;
    complete_ = complete_ && recorded_.commands.size() < Recording::max_commands;
    if (!complete_) return;
    recorded_.commands.push_back({step_, command});
    ++acted_;
}

void Session::act(const Command& command) {
    if (const auto* edit = std::get_if<Edit>(&command)) {
        for (LaneSlot& slot : lanes_) slot.lane->simulation().apply(*edit);
    } else if (const auto* change = std::get_if<SetParameter>(&command)) {
        Setup changed = setup_;
        set_parameter(changed.scene, change->key, change->value);
        set(changed);
    } else if (const auto* other = std::get_if<Arrange>(&command)) {
        arrange(*other);
    }
}

void Session::set(const Setup& setup) {
    const std::vector<Scene> scenes = lane_scenes(setup);
    for (std::size_t k = 0; k < lanes_.size(); ++k) lanes_[k].lane->simulation().set(scenes[k]);
    setup_ = setup;
}

void Session::arrange(const Arrange& a) {
    const Setup changed{setup_.scene, a.lanes, a.reference};
    const std::vector<Scene> scenes = lane_scenes(changed);
    const auto known = [&](int from) { return from >= 0 && from < static_cast<int>(lanes_.size()); };
    if (a.from.size() != a.lanes.size() || !std::all_of(a.from.begin(), a.from.end(), known))
        throw InputError("each lane goes on from one of the present " + std::to_string(lanes_.size()));
    std::vector<LaneSlot> arranged;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const int from = a.from[k];
        const bool moves = std::find(a.from.begin(), a.from.begin() + static_cast<std::ptrdiff_t>(k), from) ==
                           a.from.begin() + static_cast<std::ptrdiff_t>(k);
        if (moves) {
            arranged.push_back(std::move(lanes_[static_cast<std::size_t>(from)]));
        } else {
            // The lane that it goes on from has moved to where `from` was named first.
            const auto first = std::find(a.from.begin(), a.from.end(), from) - a.from.begin();
            const LaneSlot& other = arranged[static_cast<std::size_t>(first)];
            const LaneCheckpoint checkpoint = other.lane->checkpoint();
            std::vector<Reduced> reduced = other.reduced;
            arranged.push_back({std::make_unique<Lane>(checkpoint.simulation.scene, *pool_), next_id_++, {}});
            arranged.back().reduced = std::move(reduced);
            arranged.back().lane->restore(checkpoint);
        }
    }
    lanes_ = std::move(arranged);
    for (std::size_t k = 0; k < lanes_.size(); ++k) lanes_[k].lane->simulation().set(scenes[k]);
    setup_ = changed;
}

void Session::rewind(long step) {
    if (!complete_) throw InputError("more was drawn than a recording holds; restart to record anew");
    const auto before = kept_.before(step);
    const SessionCheckpoint* kept = before.second;
    if (kept == nullptr) return begin();
    step_ = before.first;
    time_ = kept->time;
    acted_ = kept->acted;
    setup_ = kept->setup;
    next_id_ = kept->next_id;
    std::vector<LaneSlot> slots;
    for (std::size_t k = 0; k < kept->lanes.size(); ++k) {
        const auto same = std::find_if(lanes_.begin(), lanes_.end(), [&](const LaneSlot& slot) {
            return slot.lane != nullptr && slot.id == kept->ids[k];
        });
        // A lane that is still there has what it needs for its grid.
        slots.push_back(same != lanes_.end()
                            ? std::move(*same)
                            : LaneSlot{std::make_unique<Lane>(kept->lanes[k].simulation.scene, *pool_),
                                       kept->ids[k],
                                       {}});
        slots.back().lane->restore(kept->lanes[k]);
        slots.back().limits.reset();
    }
    lanes_ = std::move(slots);
    observe();
    const std::string refusal = act_recorded();
    measure();
    fail_with(refusal);
}

SessionCheckpoint Session::checkpoint() const {
    SessionCheckpoint checkpoint{
        .time = time_, .acted = acted_, .next_id = next_id_, .setup = setup_, .ids = {}, .lanes = {}};
    for (const LaneSlot& slot : lanes_) {
        checkpoint.ids.push_back(slot.id);
        checkpoint.lanes.push_back(slot.lane->checkpoint());
    }
    return checkpoint;
}

void Session::watch_limiters(bool watch) {
    if (watches_limiters_ == watch) return;
    watches_limiters_ = watch;
    observe();
    measure();
}

void Session::ask(std::span<const Measure* const> asked) {
    std::vector<const Measure*> on_demand;
    std::copy_if(asked.begin(), asked.end(), std::back_inserter(on_demand),
                 [](const Measure* measure) { return measure->on_demand(); });
    if (asked_ == on_demand) return;
    asked_ = std::move(on_demand);
    observe();
    measure();
}

bool Session::is_asked(const Measure& measure) const {
    return std::find(asked_.begin(), asked_.end(), &measure) != asked_.end();
}

bool Session::marks_limiters() const {
    return watches_limiters_ || std::any_of(asked_.begin(), asked_.end(), [](const Measure* measure) {
               return measure->needs == Needs::LimiterMasks;
           });
}

/// After a step, before anything else changes its fields: what is asked for of it.
void Session::observe() {
    for (LaneSlot& slot : lanes_) {
        note_limiters(slot);
        slot.reduced.clear();
        if (slot.lane->failure()) continue;
        for (const Measure* measure : asked_) {
            if (measure->row) slot.reduced.push_back({measure, {}});
        }
        reducer_.reduce(slot.lane->simulation().state(), *pool_, slot.reduced);
    }
}

void Session::note_limiters(LaneSlot& slot) {
    const auto last = marks_limiters() ? slot.lane->simulation().last_advection() : std::nullopt;
    if (!last || slot.lane->failure()) {
        slot.limits.reset();
        return;
    }
    if (!slot.limits) slot.limits.emplace();
    mark_limits(*last, *pool_, *slot.limits);
}

const LimiterMasks* Session::limits(std::size_t k) const {
    const LaneSlot& slot = lanes_[k];
    const bool fits =
        slot.limits && slot.limits->density.same_shape(slot.lane->simulation().state().density());
    return fits ? &*slot.limits : nullptr;
}

void Session::measure() {
    for (std::size_t k = 0; k < lanes_.size(); ++k) {
        lanes_[k].measures = lanes_[k].lane->simulation().measures();
        if (limits(k) != nullptr) lanes_[k].measures.limited = lanes_[k].limits->counts;
        lanes_[k].measures.reduced = lanes_[k].reduced;
    }
    if (setup_.reference == no_reference) return;
    const Lane& reference = *lanes_[static_cast<std::size_t>(setup_.reference)].lane;
    if (!reference.failure()) measure_against(reference.simulation());
}

/// Where the exact solution is not known, the reference stands for it.
void Session::measure_against(const Simulation& reference) {
    for (LaneSlot& slot : lanes_) {
        const Simulation& s = slot.lane->simulation();
        if (&s == &reference || std::isfinite(slot.measures.errors.L1) || slot.lane->failure()) continue;
        const Field& density = s.state().density();
        if (!averaged_.same_shape(density)) averaged_ = s.state().boundary.field(Site::Centre);
        averager_.average(reference.state().density(), reference.state().boundary, s.state().grid(),
                          averaged_);
        slot.measures.errors = errors(density, averaged_, s.state().boundary);
    }
}

Recording Session::recording() const {
    Recording now{recorded_.setup, {}, step_};
    now.commands.assign(recorded_.commands.begin(),
                        recorded_.commands.begin() + static_cast<std::ptrdiff_t>(acted_));
    return now;
}

Recording Session::whole_recording() const {
    Recording whole = recorded_;
    whole.step = last_step_;
    return whole;
}

bool Session::running() const {
    return std::any_of(lanes_.begin(), lanes_.end(),
                       [](const LaneSlot& slot) { return !slot.lane->failure().has_value(); });
}

std::uint64_t Session::digest() const {
    Digest digest;
    for (const LaneSlot& slot : lanes_) {
        const Simulation& simulation = slot.lane->simulation();
        digest.add(simulation.state(), simulation.memory_digest());
    }
    return digest.value();
}

}  // namespace whorl
