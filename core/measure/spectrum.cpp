#include "core/measure/spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace whorl {
namespace {

/// One axis of a domain: its samples, continued to a whole period of the modes.
struct Axis {
    Axis(int cells, bool closes)
        : wraps(closes),
          samples(cells),
          period(wraps ? cells : 2 * cells),
          modes(wraps ? cells / 2 + 1 : cells) {}

    bool wraps;
    int samples;  ///< one a cell
    int period;   ///< in cells; between walls, the domain and its mirror image
    int modes;    ///< that a real line may have, of wave numbers 0, 1, 2 … a period

    /// How many of the modes of a period have this wave number: itself, and its negative.
    double count(int mode) const { return mode == 0 || 2 * mode == period ? 1 : 2; }
};

/// A wave number over Δk: how many waves fit the longer of two periods.
double waves(int mode, const Axis& axis, int longer) {
    return static_cast<double>(static_cast<long>(mode) * longer) / axis.period;
}

/// Doubles between rows, so that columns of 2ⁿ rows do not all meet in one set of the cache.
constexpr int cache_line = 8;

int shell(double along, double across) {
    return static_cast<int>(std::lround(std::sqrt(along * along + across * across)));
}

}  // namespace

struct Spectrum::Transform {
    Eigen::FFT<double> fft;
    std::vector<double> line;                 ///< one period
    std::vector<std::complex<double>> modes;  ///< of the line
    std::vector<double> real, imaginary;      ///< after the first axis: a row a mode

    Transform() { fft.SetFlag(Eigen::FFT<double>::HalfSpectrum); }

    /// Modes of the line, unscaled.
    void run(int period) {
        if (period == 1) {  // which Eigen's FFT cannot do
            modes[0] = line[0];
        } else {
            fft.fwd(modes.data(), line.data(), period);
        }
    }
};

Spectrum::Spectrum() : transform_(std::make_unique<Transform>()) {}
Spectrum::~Spectrum() = default;
Spectrum::Spectrum(Spectrum&&) noexcept = default;
Spectrum& Spectrum::operator=(Spectrum&&) noexcept = default;

void Spectrum::compute(const FaceVelocity& velocity, const Boundary& boundary) {
    set_shells(boundary);
    add(velocity.u, boundary);
    add(velocity.v, boundary);
}

void Spectrum::set_shells(const Boundary& boundary) {
    const Grid& grid = boundary.grid();
    const Axis x(grid.nx, boundary.wraps().x);
    const Axis y(grid.ny, boundary.wraps().y);
    const int longer = std::max(x.period, y.period);
    spacing_ = 2 * std::numbers::pi / (longer * grid.h);
    k_.resize(1 + shell(waves(x.modes - 1, x, longer), waves(y.modes - 1, y, longer)));
    for (std::size_t b = 0; b < k_.size(); ++b) k_[b] = static_cast<double>(b) * spacing_;
    energy_.assign(k_.size(), 0);
}

/// Adds the energy of one component: first along the axis that it points in, where it is odd across walls,
/// then across. A sine's modes are imaginary, so that between walls half of what the first pass leaves is 0.
/// Of a complex line the two parts are transformed apart: a wave number and its negative have the same energy
/// together, and share a shell.
void Spectrum::add(const Field& face, const Boundary& boundary) {
    const bool points_in_x = face.site() == Site::FaceX;
    const Grid& grid = boundary.grid();
    const Axis x(grid.nx, boundary.wraps().x);
    const Axis y(grid.ny, boundary.wraps().y);
    const Axis& along = points_in_x ? x : y;
    const Axis& across = points_in_x ? y : x;
    const int longer = std::max(along.period, across.period);
    Transform& t = *transform_;
    t.line.resize(longer);
    t.modes.resize(static_cast<std::size_t>(longer) / 2 + 1);
    const std::size_t stride = across.samples + cache_line;
    for (std::vector<double>* plane : {&t.real, &t.imaginary}) plane->resize(along.modes * stride);

    for (int b = 0; b < across.samples; ++b) {
        for (int a = 0; a < along.samples; ++a) {
            const int i = points_in_x ? a : b;
            const int j = points_in_x ? b : a;
            const bool open = points_in_x ? boundary.open_x(i, j) : boundary.open_y(i, j);
            t.line[a] = open ? static_cast<double>(face(i, j)) : 0;
        }
        if (!along.wraps) {
            t.line[along.samples] = 0;  // the far wall
            for (int a = 1; a < along.samples; ++a) t.line[along.period - a] = -t.line[a];
        }
        t.run(along.period);
        for (int mode = 0; mode < along.modes; ++mode) {
            const std::size_t at = mode * stride + b;
            if (along.wraps) t.real[at] = t.modes[mode].real();
            t.imaginary[at] = t.modes[mode].imag();
        }
    }

    const double modes = static_cast<double>(along.period) * across.period;
    const double scale = 0.5 / (modes * modes * spacing_);
    for (int mode = 0; mode < along.modes; ++mode) {
        for (const std::vector<double>* plane : {&t.real, &t.imaginary}) {
            if (!along.wraps && plane == &t.real) continue;
            const double* row = plane->data() + mode * stride;
            std::copy(row, row + across.samples, t.line.begin());
            if (!across.wraps) std::reverse_copy(row, row + across.samples, t.line.begin() + across.samples);
            t.run(across.period);
            for (int other = 0; other < across.modes; ++other) {
                energy_[shell(waves(mode, along, longer), waves(other, across, longer))] +=
                    scale * along.count(mode) * across.count(other) * std::norm(t.modes[other]);
            }
        }
    }
}

}  // namespace whorl
