// The kinetic-energy spectrum of a flow.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/grid/boundary.h"

namespace whorl {

/// E(k): how the mean kinetic energy ½⟨|u|²⟩ is spread over wave numbers, Σ E(k) Δk = ½⟨|u|²⟩, the mean being
/// taken over the area of the whole domain.
///
/// Modes are Fourier's where sides are periodic, and the sines and cosines of free-slip walls in a box: u is
/// odd across the walls in x and even across those in y, v the other way round. A mode of wave vector κ
/// counts in the shell of the k nearest to |κ|. Of a domain with obstacles the same modes are taken, with 0
/// on every face that no fluid may cross: their edges then add to high k.
///
/// Allocates where a shape is new. Works in double precision on the calling thread and shares nothing: it may
/// run beside the simulation, on a copy of the velocity. Any shape will do. One thread takes 1 ms at 128², 3
/// at 256² and 17 at 512² in a box, somewhat over half of that in a periodic domain. A large prime factor in
/// a side's number of cells is slow: 0.2 s at 257².
class Spectrum {
  public:
    Spectrum();
    ~Spectrum();
    Spectrum(Spectrum&&) noexcept;
    Spectrum& operator=(Spectrum&&) noexcept;

    /// @param velocity of the boundary's shape; ghosts are not read
    void compute(const FaceVelocity& velocity, const Boundary& boundary);

    /// Wave numbers 0, Δk, 2Δk …, radians per length.
    std::span<const double> k() const { return k_; }
    /// E at those, length³/time².
    std::span<const double> energy() const { return energy_; }
    /// Δk: the lowest wave number along the longer side L, 2π/L where it is periodic and π/L in a box.
    double spacing() const { return spacing_; }

  private:
    struct Transform;

    void set_shells(const Boundary& boundary);
    void add(const Field& face, const Boundary& boundary);

    std::unique_ptr<Transform> transform_;
    std::vector<double> k_, energy_;
    double spacing_ = 0;
};

}  // namespace whorl
