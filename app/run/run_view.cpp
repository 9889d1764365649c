#include "app/run/run_view.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"

namespace whorl::app {
namespace {

/// The key without the set of schemes that it belongs to.
std::string_view bare(std::string_view key) {
    return key.substr(scheme_set_prefix(key).size());
}

std::size_t place_of(int id, const std::vector<int>& ids, std::size_t otherwise) {
    const auto found = std::find(ids.begin(), ids.end(), id);
    return found == ids.end() ? otherwise : static_cast<std::size_t>(found - ids.begin());
}

}  // namespace

std::string_view scheme_set_prefix(std::string_view key) {
    const std::size_t dot = key.find('.');
    return dot == std::string_view::npos ? std::string_view() : key.substr(0, dot + 1);
}

bool same_parameter(std::string_view a, std::string_view b) {
    if (a == b) return true;
    return bare(a) == bare(b) && (bare(a) == a || bare(b) == b);
}

void RunView::settle() {
    while (!pending_.empty() && pending_.front().ticket <= session_->taken) pending_.pop_front();
    setup_ = session_->setup;
    ids_ = session_->ids;
    for (const Pending& p : pending_) foresee(p.command);
    if (setup_.lanes.size() == 1) lane_only_ = false;
    choose_scene();
}

void RunView::foresee(const Command& command) {
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
void RunView::choose_scene() {
    scene_ = setup_.scene;
    if (!lane_only_) return;
    try {
        scene_ = lane_scene(setup_.scene, setup_.lanes[selected_in_setup()]);
    } catch (const InputError&) {
        scene_ = snapshot().scene;
    }
}

std::size_t RunView::selected() const {
    return place_of(selected_id_, session_->ids, 0);
}

std::size_t RunView::selected_in_setup() const {
    return place_of(selected_id_, ids_, 0);
}

std::size_t RunView::other() const {
    const std::size_t next = (selected() + 1) % session_->lanes.size();
    const std::size_t before = place_of(previous_id_, session_->ids, next);
    return before == selected() ? next : before;
}

bool RunView::overridden(const Parameter& p, std::size_t lane) const {
    const auto& overrides = setup_.lanes[lane].overrides;
    return std::any_of(overrides.begin(), overrides.end(),
                       [&](const SetParameter& o) { return same_parameter(o.key, p.key); });
}

Arrange RunView::arrangement() const {
    Arrange same{setup_.lanes, std::vector<int>(setup_.lanes.size()), setup_.reference};
    std::iota(same.from.begin(), same.from.end(), 0);
    return same;
}

}  // namespace whorl::app
