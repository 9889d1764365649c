#include "core/grid/boundary.h"

#include <algorithm>
#include <stdexcept>

namespace whorl {
namespace {

int wrap(int i, int n) {
    const int r = i % n;
    return r < 0 ? r + n : r;
}

/// Whether `fill`, `enforce` and open faces are what a kind of side asks for.
bool keeps(const SideKind& kind) {
    return kind.wraps ||
           (kind.normal == Condition::Zero && kind.tangential == Condition::ZeroGradient &&
            kind.scalars == Condition::ZeroGradient && kind.pressure == Condition::ZeroGradient);
}

}  // namespace

Boundary::Boundary(Grid grid, const Sides& sides)
    : grid_(grid), sides_(sides), mask_(static_cast<std::size_t>(grid.nx) * grid.ny, 0) {
    if (sides.wraps() != Wraps{sides.right.kind->wraps, sides.top.kind->wraps})
        throw std::invalid_argument("a side wraps where the opposite one does too");
    for (const Side& side : {sides.left, sides.right, sides.bottom, sides.top}) {
        if (!keeps(*side.kind))
            throw std::invalid_argument("no boundary keeps the conditions of a side that is " +
                                        std::string(side.kind->key));
    }
    for (const Site site : {Site::Centre, Site::FaceX, Site::FaceY})
        rules_[static_cast<int>(site)] = make_rule(site);
}

bool Boundary::solid(int i, int j) const {
    // All sides that do not wrap are closed.
    return !inside(i, j, grid_.nx, grid_.ny) || mask_[static_cast<std::size_t>(j) * grid_.nx + i] != 0;
}

bool Boundary::inside(int& i, int& j, int nx, int ny) const {
    if (wraps().x) i = wrap(i, nx);
    if (wraps().y) j = wrap(j, ny);
    return i >= 0 && j >= 0 && i < nx && j < ny;
}

void Boundary::set_solids(std::vector<std::uint8_t> mask) {
    if (mask.size() != mask_.size()) throw std::invalid_argument("a mask of solids has one entry a cell");
    if (mask == mask_) return;
    mask_ = std::move(mask);
    solids_ = static_cast<int>(mask_.size() - std::count(mask_.begin(), mask_.end(), std::uint8_t{0}));
    ++revision_;
    for (const Site site : {Site::Centre, Site::FaceX, Site::FaceY})
        rules_[static_cast<int>(site)] = make_rule(site);
}

std::size_t Boundary::bytes() const {
    std::size_t sum = sizeof(Boundary) + mask_.size();
    for (const SolidRule& r : rules_) sum += sizeof(Copy) * r.nearest.size() + sizeof(int) * r.closed.size();
    return sum;
}

std::pair<int, int> Boundary::shape(Site site) const {
    return {grid_.nx + (site == Site::FaceX && !wraps().x ? 1 : 0),
            grid_.ny + (site == Site::FaceY && !wraps().y ? 1 : 0)};
}

Field Boundary::field(Site site, Real value) const {
    const auto [width, height] = shape(site);
    return {width, height, site, value};
}

Boundary::SolidRule Boundary::make_rule(Site site) const {
    const auto [width, height] = shape(site);
    SolidRule rule;
    std::vector<int> source(static_cast<std::size_t>(width) * height, -1);
    std::vector<int> front;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const bool here = !solid(i, j);
            const bool before = site == Site::FaceX   ? !solid(i - 1, j)
                                : site == Site::FaceY ? !solid(i, j - 1)
                                                      : here;
            const int at = j * width + i;
            if (here != before) rule.closed.push_back(at);
            if (here || before) {
                source[at] = at;
                front.push_back(at);
            }
        }
    }
    // Breadth first from the samples that fluid touches: each solid sample takes the nearest one's value.
    while (!front.empty()) {
        std::vector<int> next;
        for (const int at : front) {
            const int i = at % width;
            const int j = at / width;
            constexpr int steps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
            for (const auto& step : steps) {
                int ni = i + step[0];
                int nj = j + step[1];
                if (!inside(ni, nj, width, height)) continue;
                const int to = nj * width + ni;
                if (source[to] >= 0) continue;
                source[to] = source[at];
                rule.nearest.push_back({to, source[at]});
                next.push_back(to);
            }
        }
        front = std::move(next);
    }
    return rule;
}

void Boundary::fill(Field& field) const {
    constexpr int g = Field::ghost;
    const int width = field.width();
    const int height = field.height();
    for (const Copy& copy : rule(field.site()).nearest) {
        field(copy.to % width, copy.to / width) = field(copy.from % width, copy.from / width);
    }
    const auto [wraps_x, wraps_y] = wraps();
    int left[g], right[g];  // where the ghost samples of a row come from
    for (int k = 0; k < g; ++k) {
        left[k] = wraps_x ? wrap(-1 - k, width) : 0;
        right[k] = wraps_x ? k % width : width - 1;
    }
    for (int j = 0; j < height; ++j) {
        Real* row = field.row(j);
        for (int k = 0; k < g; ++k) {
            row[-1 - k] = row[left[k]];
            row[width + k] = row[right[k]];
        }
    }
    for (int k = 1; k <= g; ++k) {
        const Real* below = field.row(wraps_y ? wrap(-k, height) : 0);
        const Real* above = field.row(wraps_y ? (k - 1) % height : height - 1);
        std::copy(below - g, below + width + g, field.row(-k) - g);
        std::copy(above - g, above + width + g, field.row(height - 1 + k) - g);
    }
}

void Boundary::enforce(FaceVelocity& velocity) const {
    for (Field* field : {&velocity.u, &velocity.v}) {
        for (const int at : rule(field->site()).closed)
            (*field)(at % field->width(), at / field->width()) = 0;
        if (fluid_cells() == 0) field->set_all(0);
        fill(*field);
    }
}

}  // namespace whorl
