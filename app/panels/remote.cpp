#include "app/panels/remote.h"

#include <algorithm>

#include "core/scene/error.h"

namespace whorl::app {
namespace {

/// "velocity.", "scalars." or nothing: which scheme set a key belongs to.
std::string prefix_of(std::string_view key) {
    const std::size_t dot = key.find('.');
    return dot == std::string_view::npos ? std::string() : std::string(key.substr(0, dot + 1));
}

// By then a snapshot shows whatever has been pushed: the step that was running and two more have ended.
constexpr std::uint64_t settled_snapshots = 3;
constexpr double settled_seconds = 0.3;

}  // namespace

void Remote::begin_frame() {
    snapshot_ = &player_.newest();
    if (std::string complaint = player_.take_complaint(); !complaint.empty()) {
        notices_.warn(std::move(complaint));
        edits_.clear();
    }
    settle();
}

void Remote::settle() {
    // Edits act in order: with the last that shows, all before it have acted.
    const auto acted = std::find_if(edits_.rbegin(), edits_.rend(), [&](const Edit& edit) {
        return edit.parameter->get(snapshot_->scene) == edit.value;
    });
    edits_.erase(edits_.begin(), acted.base());
    std::erase_if(edits_, [&](const Edit& edit) {
        return snapshot_->serial >= edit.serial + settled_snapshots &&
               notices_.time() > edit.time + settled_seconds;
    });
    scene_ = snapshot_->scene;
    for (const Edit& edit : edits_) edit.parameter->set(scene_, edit.value);
}

void Remote::push_edit(const Parameter& parameter, double value) {
    std::erase_if(edits_, [&](const Edit& edit) { return edit.parameter == &parameter; });
    edits_.push_back({&parameter, value, snapshot_->serial, notices_.time()});
    parameter.set(scene_, value);
    player_.push(SetParameter{parameter.key, parameter.text(value)});
}

void Remote::set(const Parameter& p, double value) {
    try {
        p.check(value);
    } catch (const InputError& e) {
        notices_.warn(e.what());
        return;
    }
    Scene wanted = scene_;
    p.set(wanted, value);
    if (!conflict(wanted).empty()) {
        // A scheme that needs linear sampling brings it along; anything else is the run's to refuse.
        const Parameter& interpolation = parameter(prefix_of(p.key) + "interpolation");
        const double linear = interpolation.parse(Linear::info.key);
        interpolation.set(wanted, linear);
        if (&p != &interpolation && conflict(wanted).empty()) {
            const double before = interpolation.get(scene_);
            push_edit(interpolation, linear);
            notices_.info(interpolation.label + " is now " +
                          std::string(interpolation.choices[static_cast<std::size_t>(linear)].label) +
                          " (was " +
                          std::string(interpolation.choices[static_cast<std::size_t>(before)].label) + "): " +
                          std::string(p.kind == Parameter::Kind::Choice
                                          ? p.choices[static_cast<std::size_t>(value)].label
                                          : std::string_view(p.label)) +
                          " takes values and gradients from linear weights [thesis eq. 4.2–4.3]");
        }
    }
    push_edit(p, value);
}

void Remote::load(std::string_view key, const Scene& scene) {
    try {
        player_.load(scene);
        loaded_ = key;
        edits_.clear();
    } catch (const InputError& e) {
        notices_.warn(e.what());
    }
}

void Remote::restart() {
    player_.push(Restart{});
}

void Remote::set_pace(Pace pace) {
    pace_ = pace;
    player_.set_pace(pace);
}

}  // namespace whorl::app
