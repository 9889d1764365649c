#include "app/run/session_client.h"

namespace whorl::app {

void SessionClient::begin_frame() {
    const int run = session_ != nullptr ? session_->run : 0;
    const std::size_t place = session_ != nullptr ? selected() : 0;
    const std::size_t before = session_ != nullptr ? other() : 0;
    // First: where nothing is sought any more, the newest snapshot shows it.
    seek_target_ = player_.seek_target();
    session_ = &player_.newest();
    if (session_->run != run) {
        // Another run numbers its lanes anew: what was selected stays by its place.
        const auto id_at = [&](std::size_t k) {
            return k < session_->ids.size() ? session_->ids[k] : unknown;
        };
        selected_id_ = id_at(place);
        previous_id_ = id_at(before);
    }
    if (std::string error = player_.take_error(); !error.empty()) {
        notifications_.warn(std::move(error));
    }
    if (to_select_ && to_select_->first <= session_->taken) {
        if (to_select_->second < session_->ids.size()) select_id(session_->ids[to_select_->second]);
        to_select_.reset();
    }
    settle();
    names_.update(session_->setup);
}

}  // namespace whorl::app
