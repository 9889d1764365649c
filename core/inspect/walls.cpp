#include "core/inspect/walls.h"

namespace whorl {

WallRules::WallRules(const Boundary& boundary, Site site)
    : sources_(boundary.field(site)), open_(boundary.field(site, 1)) {
    // A Real holds more whole numbers than a scene may have cells.
    for (int j = 0; j < sources_.height(); ++j) {
        for (int i = 0; i < sources_.width(); ++i)
            sources_(i, j) = static_cast<Real>(j * sources_.width() + i);
    }
    boundary.fill(sources_);
    if (site == Site::Centre) return;
    FaceVelocity faces = boundary.velocity();
    Field& ours = site == Site::FaceX ? faces.u : faces.v;
    ours.set_all(1);
    boundary.enforce(faces);
    open_ = ours;
}

std::pair<int, int> WallRules::source(int i, int j) const {
    const int number = static_cast<int>(sources_(i, j));
    return {number % sources_.width(), number / sources_.width()};
}

}  // namespace whorl
