#include "app/inspector/inspector.h"

#include <algorithm>
#include <glm/common.hpp>

namespace whorl::app {
namespace {

constexpr double margin = 2;       // cells around all that is drawn
constexpr double least_cells = 8;  // across the shorter side

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
    glm::dvec2 low() const { return low_; }
    glm::dvec2 high() const { return high_; }

  private:
    glm::dvec2 low_{1e300}, high_{-1e300};
};

Box box_of(const Explanation& e) {
    Box box;
    box.add(e.at);
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

ViewWindow window_around(const Explanation& explanation, glm::dvec2 domain, double h) {
    const Box box = box_of(explanation);
    const glm::dvec2 low = box.low() - margin * h;
    const glm::dvec2 high = box.high() + margin * h;
    // Both sides are the same part of the domain's, so that cells stay square.
    const glm::dvec2 needed = (high - low) / domain;
    const double least = least_cells * h / std::min(domain.x, domain.y);
    const double part = std::min(1.0, std::max({needed.x, needed.y, least}));
    const glm::dvec2 corner =
        glm::clamp(0.5 * (low + high) / domain - 0.5 * part, glm::dvec2(0), glm::dvec2(1 - part));
    return {glm::vec2(corner), glm::vec2(corner + part)};
}

}  // namespace whorl::app
