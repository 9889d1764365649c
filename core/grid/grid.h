// The shape of the domain in square cells, and where a field's samples sit in a cell.
#pragma once

namespace whorl {

/// Where the samples of a field sit: cell centres, or the faces that the x or y velocity crosses (MAC grid).
enum class Site { Centre, FaceX, FaceY };

/// Offset of a site's first sample from the domain's corner, in cells.
constexpr double offset_x(Site site) {
    return site == Site::FaceX ? 0.0 : 0.5;
}
constexpr double offset_y(Site site) {
    return site == Site::FaceY ? 0.0 : 0.5;
}

/// `nx × ny` square cells of side `h` (length units). One row of cells is a one-dimensional domain.
struct Grid {
    int nx = 0;
    int ny = 0;
    double h = 1.0;

    int dimensions() const { return ny == 1 ? 1 : 2; }
    double width() const { return nx * h; }
    double height() const { return ny * h; }
    /// h^d, the measure of one cell (length^d).
    double cell() const { return dimensions() == 1 ? h : h * h; }
    bool operator==(const Grid&) const = default;
};

}  // namespace whorl
