#include "app/inspector/inspection.h"

#include <algorithm>
#include <glm/common.hpp>

namespace whorl::app {
namespace {

constexpr double margin = 0.5;  // cells around all that is drawn, for dots and their weights
constexpr double share = 0.5;   // of the sides, for what is drawn of the chosen lane

class Box {
  public:
    void add(WorldPoint p) {
        low_ = glm::min(low_, glm::dvec2(p.x, p.y));
        high_ = glm::max(high_, glm::dvec2(p.x, p.y));
    }
    void add(const Path& path) {
        add(path.start);
        add(path.end);
    }
    void add(const Box& other) {
        low_ = glm::min(low_, other.low_);
        high_ = glm::max(high_, other.high_);
    }
    glm::dvec2 low() const { return low_; }
    glm::dvec2 high() const { return high_; }

  private:
    glm::dvec2 low_{1e300}, high_{-1e300};
};

Box box_of(const Explanation& e, double h) {
    Box box;
    box.add(WorldPoint{e.at.x - 0.5 * h, e.at.y - 0.5 * h});
    box.add(WorldPoint{e.at.x + 0.5 * h, e.at.y + 0.5 * h});
    for (const BaseStep& step : e.steps) {
        box.add(step.path);
        for (const KernelNode& node : step.nodes) box.add(node.at);
        for (const StencilParticle& particle : step.particles) box.add(particle.path);
    }
    return box;
}

}  // namespace

const Sum& sum_of(const Explanation& explanation, std::size_t step) {
    if (!explanation.correction) return explanation.sum;
    const std::vector<Sum>& parts = explanation.sum.parts;
    return step < 2 ? parts[step] : parts.back();
}

ViewWindow window_around(const Explanation& chosen, std::span<const Explanation* const> others,
                         glm::dvec2 domain, double h) {
    const Box box = box_of(chosen, h);
    Box all = box;
    for (const Explanation* other : others) all.add(box_of(*other, h));
    const glm::dvec2 low = (all.low() - margin * h) / domain, high = (all.high() + margin * h) / domain;
    // Both sides are the same part of the domain's, so that cells stay square.
    const glm::dvec2 needed = glm::max((box.high() - box.low()) / (share * domain), high - low);
    const double least = static_cast<double>(closest_cells) * h / std::min(domain.x, domain.y);
    const double part = std::min(1.0, std::max({needed.x, needed.y, least}));
    // The chosen lane's in the middle, as far as all is seen.
    const glm::dvec2 centred = 0.5 * (box.low() + box.high()) / domain - 0.5 * part;
    const glm::dvec2 corner =
        glm::clamp(glm::max(glm::min(centred, low), high - part), glm::dvec2(0), glm::dvec2(1 - part));
    return {glm::vec2(corner), glm::vec2(corner + part)};
}

}  // namespace whorl::app
