#include "app/labs/slice.h"

#include <algorithm>
#include <cmath>

#include "app/labs/between.h"

namespace whorl::app {

int SliceLine::index(const Grid& grid) const {
    const int rows = vertical ? grid.nx : grid.ny;
    return std::clamp(static_cast<int>(place * rows), 0, rows - 1);
}

namespace {

bool solid(const Snapshot& lane, const SliceLine& line, int k) {
    const int across = line.index(lane.grid);
    const int i = line.vertical ? across : k;
    const int j = line.vertical ? k : across;
    return lane.solids[static_cast<std::size_t>(j) * lane.grid.nx + i] != 0;
}

}  // namespace

SliceCurve cells_along(const Field& field, const Snapshot& lane, const SliceLine& line) {
    SliceCurve curve;
    const int across = line.index(lane.grid);
    for (int k = 0; k < line.count(lane.grid); ++k) {
        const Real value = line.vertical ? field(across, k) : field(k, across);
        curve.x.push_back(static_cast<float>((k + 0.5) * lane.grid.h));
        curve.y.push_back(solid(lane, line, k) ? NAN : static_cast<float>(value));
    }
    return curve;
}

SliceCurve curve_along(const Field& field, const Snapshot& lane, const SliceLine& line,
                       const SchemeSet& schemes, int per_cell) {
    SliceCurve curve;
    const auto across = static_cast<double>(line.index(lane.grid));
    const int last = (line.count(lane.grid) - 1) * per_cell;
    std::vector<glm::dvec2> places;
    for (int m = 0; m <= last; ++m) {
        const double along = static_cast<double>(m) / per_cell;
        places.emplace_back(line.vertical ? across : along, line.vertical ? along : across);
        curve.x.push_back(static_cast<float>((along + 0.5) * lane.grid.h));
    }
    curve.y.resize(places.size());
    sample_between(field, schemes, lane.periodic, places, curve.y);
    for (int m = 0; m <= last; ++m) {
        if (solid(lane, line, (m + per_cell / 2) / per_cell)) curve.y[static_cast<std::size_t>(m)] = NAN;
    }
    return curve;
}

const Field& FilledFields::of(std::size_t lane, const Snapshot& snapshot, const Field& field, long version) {
    if (lanes_.size() <= lane) lanes_.resize(lane + 1);
    auto& [domain, filled, filled_version] = lanes_[lane];
    if (filled_version == version) return filled;
    filled_version = version;
    if (!(domain.grid() == snapshot.grid) || domain.periodic() != snapshot.periodic)
        domain = Boundary(snapshot.grid, snapshot.periodic ? Sides::of<Periodic>() : Sides::of<Box>());
    if (domain.solids() != snapshot.solids) domain.set_solids(snapshot.solids);
    filled = field;
    domain.fill(filled);
    return filled;
}

}  // namespace whorl::app
