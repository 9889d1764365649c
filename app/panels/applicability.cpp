#include "app/panels/applicability.h"

#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

using Group = Parameter::Group;

std::string label(const SchemeInfo& info) {
    return std::string(info.label);
}

/// The scheme that makes the step's particles.
std::string family(const SchemeSet& s) {
    return label(s.step_info());
}

std::string inactive_reason(std::string_view key, const SchemeSet& s, const Scene& scene) {
    if (key == "base" && !s.predictor_corrector()) {
        return label(s.advector.info()) +
               " is a single step: only predictor-correctors stand on a base step.";
    }
    if (key == "interpolation" && s.affine()) {
        return family(s) + " takes values and gradients from linear weights [thesis eq. 4.2–4.3].";
    }
    if (key == "clamped") {
        if (!s.interpolation->traits.overshoots) {
            return label(s.interpolation.info()) +
                   " never leaves the range of its nodes: there is nothing to cut.";
        }
    }
    if (key == "axis-order") {
        if (scene.dimensions == 1) return "There is one axis only.";
        if (s.interpolation->traits.bilinear) {
            return label(s.interpolation.info()) + " interpolation gives the same along either axis first.";
        }
    }
    if (key == "limiter" && !s.predictor_corrector() && !s.affine()) {
        return label(s.advector.info()) + " needs no limiter: nothing is corrected.";
    }
    if ((key == "zeta" || key == "weights" || key == "stencil") && !s.affine()) {
        return label(s.advector.info()) + " traces the node alone; only the ASLAM family has particles.";
    }
    return {};
}

bool carries(std::string_view key, std::string_view prefix) {
    return key.substr(0, prefix.size()) == prefix;
}

}  // namespace

std::string inactive_reason(const Parameter& p, const Scene& scene) {
    const bool prescribed = experiment(scene.experiment).flow != nullptr;
    const auto known_flow = [&] {
        return label(experiment(scene.experiment).info) + " prescribes its flow: nothing is solved for.";
    };
    if (p.group == Group::Forces || p.group == Group::Pressure || p.key == "order") {
        if (prescribed) return known_flow();
    }
    if (p.key == "seed" && !scene.velocity.stencil->traits.seeded && !scene.scalars.stencil->traits.seeded) {
        return "Only the jittered stencil is random.";
    }
    if (p.group != Group::Schemes && p.group != Group::Particles) return {};
    const std::string_view velocity = "velocity.";
    const std::string_view scalars = "scalars.";
    if (carries(p.key, velocity)) {
        if (prescribed) return known_flow();
        return inactive_reason(std::string_view(p.key).substr(velocity.size()), scene.velocity, scene);
    }
    const std::string_view key = p.key;
    return inactive_reason(carries(key, scalars) ? key.substr(scalars.size()) : key, scene.scalars, scene);
}

}  // namespace whorl::app
