#include "core/advection/lattice.h"

#include <algorithm>
#include <cmath>

namespace whorl {
namespace {

constexpr Site all_sites[] = {Site::Centre, Site::FaceX, Site::FaceY};

/// The lattice point at `position` (cells from a cell's low side), if there is one.
std::optional<int> point_at(double position, int per_cell, double phase) {
    constexpr double slack = 1e-3;  // offsets are Reals
    const double steps = position * per_cell - phase;
    const double whole = std::round(steps);
    if (std::abs(steps - whole) > slack) return std::nullopt;
    return static_cast<int>(whole);
}

}  // namespace

std::optional<Lattice> Lattice::of(std::span<const Particle> particles) {
    const bool in_a_line = std::ranges::all_of(particles, [](const Particle& p) { return p.offset.y == 0; });
    const auto in_cell = [](Real d) { return std::abs(d) <= Real(0.5); };
    const bool inside = std::ranges::all_of(
        particles, [&](const Particle& p) { return in_cell(p.offset.x) && in_cell(p.offset.y); });
    if (in_a_line || !inside) return std::nullopt;
    for (int per_cell = 1; per_cell <= max_per_cell; ++per_cell) {
        for (const double phase : {0.0, 0.5}) {
            Lattice lattice(per_cell, phase);
            if (lattice.place(particles)) return lattice;
        }
    }
    return std::nullopt;
}

bool Lattice::place(std::span<const Particle> particles) {
    for (const Site site : all_sites) {
        Nodes& nodes = sites_[static_cast<int>(site)];
        const auto point = [&](const Particle& p) -> std::optional<Point> {
            const auto x = point_at(offset_x(site) + static_cast<double>(p.offset.x), per_cell_, phase_);
            const auto y = point_at(offset_y(site) + static_cast<double>(p.offset.y), per_cell_, phase_);
            if (!x || !y) return std::nullopt;
            return Point{*x, *y, p};
        };
        nodes.node = point(Particle{});
        for (const Particle& particle : particles) {
            const auto at = point(particle);
            if (!at) return false;
            if (particle.offset != Vec2(0, 0)) nodes.particles.push_back(*at);
        }
        const auto [low, high] = std::ranges::minmax(nodes.particles, {}, &Point::y);
        nodes.lowest = low.y;
        nodes.highest = high.y;
    }
    return true;
}

Lattice::Origin Lattice::origin(const Point& point) const {
    const auto cell = [&](int p) { return static_cast<int>(std::floor(static_cast<double>(p) / per_cell_)); };
    const int i = cell(point.x), j = cell(point.y);
    return {i, j, start(point.x - per_cell_ * i, point.y - per_cell_ * j)};
}

Vec2 Lattice::start(int x, int y) const {
    return Vec2((x + phase_) / per_cell_ - 0.5, (y + phase_) / per_cell_ - 0.5);
}

void LatticeTile::shape(const Lattice& lattice, int fields) {
    int lowest = 0, highest = 0;
    std::size_t particles = 0;
    for (const Site site : all_sites) {
        lowest = std::min(lowest, lattice.lowest(site));
        highest = std::max(highest, lattice.highest(site));
        particles = std::max(particles, lattice.particles(site).size());
    }
    if (contributions_.size() < particles) contributions_.resize(particles);
    for (auto& sources : sources_) {
        if (sources.size() < particles) sources.resize(particles);
    }
    slots_ = highest - lowest + 1;
    per_cell_ = lattice.per_cell();
    rows_ = displacement_rows + fields * ParticleSamples::rows;
    const std::size_t size = static_cast<std::size_t>(slots_) * per_cell_ * rows_ * stride / Line::size;
    if (lines_.size() < size) lines_.resize(size);
}

}  // namespace whorl
