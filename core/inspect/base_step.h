// One step of a base scheme at one node, taken by the solver's own kernels and written out.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/advection/advection.h"
#include "core/inspect/paths.h"

namespace whorl {

/// A field that is stepped, and what it is called.
struct NamedField {
    const Field* field;
    std::string symbol;
};

/// What came of a step at a node.
struct NodeStep {
    BaseStep drawn;
    Sum sum;
    Index cell = 0;        ///< that holds the node's departure point, as CellPositions::at
    Real first_order = 0;  ///< with particles: the linear semi-Lagrangian value
    Real value = 0;
};

/// Takes steps A at single nodes with the kernels, stencil and lattice that an Advection has for a set of
/// schemes.
class NodeStepper {
  public:
    /// @param last what it refers to must outlive this
    NodeStepper(const SchemeSet& schemes, const LastAdvection& last);

    /// One step, unlimited but for clamped interpolation.
    /// @param direction −1 traces forward
    NodeStep step(const NamedField& from, int i, int j, Real direction) const;
    /// Limits a step as a predictor-corrector limits its base steps.
    void limit_base(const Field& q, NodeStep& step) const;
    /// Limits a value as the whole scheme does, if it does.
    /// @param cell, first_order of the forward step
    void limit(const Field& q, Index cell, Real first_order, Sum& sum, Real& value) const;

  private:
    /// What a particle reads, as `SampleParticlesFn` writes it for one node.
    using ParticleRow = std::array<Real, ParticleSamples::rows * NodeSpan::size>;
    struct SampledParticle {
        const Particle* particle;
        TraceStart start;
        ParticleRow row;
    };

    TraceStart trace_start(Site site, int i, int j, Vec2 start, Real direction) const;
    TraceStart trace_start(const Lattice::Point& point, int i, int j, Real direction) const;
    Displacements displaced(const TraceStart& from) const;
    CellPositions located(const Field& q, const TraceStart& from) const;
    void draw(const NamedField& from, const TraceStart& node, const CellPositions& at, BaseStep& out) const;
    void interpolate(const NamedField& from, const CellPositions& at, NodeStep& out) const;
    ParticleRow sampled(const Field& q, const TraceStart& particle) const;
    /// The particles of a node's stencil but for the one at the node itself.
    std::vector<SampledParticle> particles(const Field& q, int i, int j, Real direction) const;
    void gather(const NamedField& from, int i, int j, const TraceStart& node, Real direction,
                const CellPositions& at, NodeStep& out) const;
    StencilParticle told(const SampledParticle& particle) const;
    Sum particle_sum(const Particle& particle, const StencilParticle& found) const;
    Real limited(LimitFn by, const Field& q, Index cell, Real first_order, Real value) const;
    Clamping cut(const Field& q, Index cell, Real before, Real after) const;

    SchemeSet schemes_;
    const LastAdvection& last_;
    Kernels kernels_;
    SampleFn unclamped_;
    LimitFn clamp_;
    Stencil stencil_;
    std::optional<Lattice> lattice_;
    Real dt_;
};

}  // namespace whorl
