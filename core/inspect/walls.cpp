#include "core/inspect/walls.h"

namespace whorl {

WallRules::WallRules(const Boundary& boundary, Site site) : numbers_(boundary.field(site)) {
    // A Real holds more whole numbers than a scene may have cells.
    for (int j = 0; j < numbers_.height(); ++j) {
        for (int i = 0; i < numbers_.width(); ++i)
            numbers_(i, j) = static_cast<Real>(j * numbers_.width() + i + 1);
    }
    boundary.fill(numbers_);
    if (site == Site::Centre) return;
    FaceVelocity faces = boundary.velocity();
    (site == Site::FaceX ? faces.u : faces.v) = numbers_;
    boundary.enforce(faces);
    numbers_ = site == Site::FaceX ? faces.u : faces.v;
}

std::optional<std::pair<int, int>> WallRules::holds(int i, int j) const {
    const int number = static_cast<int>(numbers_(i, j));
    if (number == 0) return std::nullopt;
    return std::pair((number - 1) % numbers_.width(), (number - 1) / numbers_.width());
}

}  // namespace whorl
