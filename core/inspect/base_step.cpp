#include "core/inspect/base_step.h"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "core/inspect/interpolation_sum.h"

namespace whorl {
namespace {

double number(Real value) {
    return static_cast<double>(value);
}

Kernels kernels_of(SchemeSet schemes, Wraps wraps, bool clamped, Id<Limiter> limiter) {
    schemes.clamped = clamped;
    schemes.limiter = limiter;
    return choose_kernels(schemes, wraps);
}

/// "(−0.25, 0.5)", in cells.
std::string offset_name(Vec2 offset) {
    char text[64];
    std::snprintf(text, sizeof text, "(%+.3g, %+.3g)", number(offset.x), number(offset.y));
    return text;
}

/// Where the thesis has the update of an affine scheme. A base step's clamp has a source of its own.
std::string update_source(const SchemeSet& schemes) {
    if (!schemes.predictor_corrector()) return thesis_part(schemes.advector.info().source);
    return thesis_part(schemes.base->step->info.source);
}

/// Adds a particle to what a step's sum tells and to what is drawn.
void add_particle(const Particle& particle, const StencilParticle& found, Sum part, NodeStep& out) {
    out.sum.terms.push_back({offset_name(particle.offset), found.weight, found.at_node});
    out.sum.parts.push_back(std::move(part));
    out.drawn.particles.push_back(found);
}

/// Whether clamping an interpolation is more than its own nature.
bool clamps(const SchemeSet& schemes) {
    return schemes.clamped && !schemes.interpolation->traits.bilinear;
}

}  // namespace

NodeStepper::NodeStepper(const SchemeSet& schemes, const LastAdvection& last)
    : schemes_(schemes),
      last_(last),
      kernels_(choose_kernels(schemes, last.boundary->wraps())),
      unclamped_(kernels_of(schemes, last.boundary->wraps(), false, schemes.limiter).sample),
      clamp_(kernels_of(schemes, last.boundary->wraps(), false, clamp_limiter).limit),
      stencil_(schemes.stencil, schemes.zeta, schemes.weights, last.boundary->grid().dimensions(),
               last.setup.seed),
      lattice_(schemes.affine() ? Lattice::of(stencil_.particles()) : std::nullopt),
      dt_(static_cast<Real>(last.setup.dt / last.boundary->grid().h)) {}

NodeStep NodeStepper::step(const NamedField& from, int i, int j, Real direction) const {
    const Field& q = *from.field;
    const auto& point = lattice_ ? lattice_->node(q.site()) : std::nullopt;
    const TraceStart node =
        point ? trace_start(*point, i, j, direction) : trace_start(q.site(), i, j, Vec2(0, 0), direction);
    const CellPositions at = located(q, node);
    NodeStep out;
    out.cell = at.at[0];
    draw(from, node, at, out.drawn);
    if (schemes_.affine()) {
        gather(from, i, j, node, direction, at, out);
    } else {
        interpolate(from, at, out);
    }
    return out;
}

TraceStart NodeStepper::trace_start(Site site, int i, int j, Vec2 start, Real direction) const {
    return {last_.velocity, last_.boundary, site, i, j, start, direction * dt_};
}

TraceStart NodeStepper::trace_start(const Lattice::Point& point, int i, int j, Real direction) const {
    const Lattice::Origin origin = lattice_->origin(point);
    return trace_start(Site::Centre, i + origin.i, j + origin.j, origin.start, direction);
}

Displacements NodeStepper::displaced(const TraceStart& from) const {
    Displacements d{};
    kernels_.trace({from.velocity, from.site}, {from.i, from.j, 1}, from.start, from.dt, d.x, d.y);
    return d;
}

CellPositions NodeStepper::located(const Field& q, const TraceStart& from) const {
    const Displacements d = displaced(from);
    CellPositions places{};
    kernels_.locate(q, from.site, {from.i, from.j, 1}, d.x, d.y, places);
    return places;
}

void NodeStepper::draw(const NamedField& from, const TraceStart& node, const CellPositions& at,
                       BaseStep& out) const {
    const Field& q = *from.field;
    const Grid& grid = last_.boundary->grid();
    out.path = path_of(schemes_.tracer.entry(), node);
    out.euler = path_of(euler, node);
    out.midpoint = path_of(midpoint, node);
    out.fine = fine_path(node);
    out.i = at.i[0];
    out.j = at.j[0];
    out.x = number(at.x[0]);
    out.y = number(at.y[0]);
    const WorldPoint corner = world(q, grid, out.i, out.j);
    out.read = {corner.x + out.x * grid.h, corner.y + out.y * grid.h};
    for (int k = 0; k < 4; ++k) {
        const int i = out.i + k % 2, j = out.j + k / 2;
        out.enclosing[static_cast<std::size_t>(k)] = {i, j, world(q, grid, i, j), number(q(i, j)),
                                                      std::nullopt};
    }
}

void NodeStepper::interpolate(const NamedField& from, const CellPositions& at, NodeStep& out) const {
    const Field& q = *from.field;
    Values value{};
    unclamped_(q, at, 1, value);
    const Real unclamped = value[0];
    kernels_.sample(q, at, 1, value);
    out.value = value[0];
    out.sum = interpolation_sum(q, from.symbol, *last_.boundary, schemes_,
                                {at.i[0], at.j[0], at.x[0], at.y[0]}, unclamped, out.drawn.nodes);
    out.sum.title = from.symbol + " at the departure point";
    if (!clamps(schemes_)) return;
    out.sum.cut = cut(q, out.cell, unclamped, out.value);
    out.sum.cut->by = "clamped interpolation";
    out.sum.cut->equation = "thesis eq. 3.8";
}

NodeStepper::ParticleRow NodeStepper::sampled(const Field& q, const TraceStart& particle) const {
    const std::array<const Field*, 1> fields{&q};
    ParticleRow row{};
    const Displacements d = displaced(particle);
    kernels_.sample_particles(fields, particle.site, {particle.i, particle.j, 1}, d.x, d.y,
                              {row.data(), NodeSpan::size});
    return row;
}

std::vector<NodeStepper::SampledParticle> NodeStepper::particles(const Field& q, int i, int j,
                                                                 Real direction) const {
    std::vector<SampledParticle> found;
    const auto add = [&](const Particle& particle, const TraceStart& start) {
        found.push_back({&particle, start, sampled(q, start)});
    };
    if (lattice_) {
        for (const Lattice::Point& point : lattice_->particles(q.site()))
            add(point.particle, trace_start(point, i, j, direction));
    } else {
        for (const Particle& particle : stencil_.particles()) {
            if (particle.offset == Vec2(0, 0)) continue;
            add(particle, trace_start(q.site(), i, j, particle.offset, direction));
        }
    }
    return found;
}

void NodeStepper::gather(const NamedField& from, int i, int j, const TraceStart& node, Real direction,
                         const CellPositions& at, NodeStep& out) const {
    const Field& q = *from.field;
    Values first_order{};
    if (lattice_ && lattice_->node(q.site())) {
        first_order[0] = sampled(q, node)[0];
    } else {
        kernels_.sample_linear(q, at, 1, first_order);
    }
    out.first_order = first_order[0];

    const std::vector<SampledParticle> sampled_particles = particles(q, i, j, direction);
    std::vector<Contribution> shares;
    for (const SampledParticle& p : sampled_particles) shares.push_back({p.row.data(), p.particle});
    Values sum{};
    kernels_.add_contributions(shares, NodeSpan::size, 1, first_order, sum);
    out.value = first_order[0] + sum[0];

    out.sum.title = from.symbol + " from " + std::to_string(stencil_.particles().size()) + " particles";
    out.sum.equation = update_source(schemes_);
    out.sum.total = number(out.value);
    out.sum.units = "x_s from the node, in cells";
    out.drawn.weight_sum = stencil_.weight_sum();
    // Sums of differences need the node's own particle only as what they differ from.
    Sum own = interpolation_sum(q, from.symbol, *last_.boundary, schemes_,
                                {at.i[0], at.j[0], at.x[0], at.y[0]}, out.first_order, out.drawn.nodes);
    own.title = from.symbol + " at the departure point, to first order";
    const auto centre = std::ranges::find(stencil_.particles(), Vec2(0, 0), &Particle::offset);
    if (centre != stencil_.particles().end()) {
        const StencilParticle found{.path = out.drawn.path,
                                    .weight = number(centre->weight),
                                    .value = number(out.first_order),
                                    .at_node = number(out.first_order),
                                    .contribution = number(centre->weight * out.first_order)};
        add_particle(*centre, found, std::move(own), out);
    }
    for (const SampledParticle& p : sampled_particles) {
        const StencilParticle found = told(p);
        add_particle(*p.particle, found, particle_sum(*p.particle, found), out);
    }
}

StencilParticle NodeStepper::told(const SampledParticle& p) const {
    const Particle alone{p.particle->offset, 1};
    const Values nothing{};
    Values carried{}, contribution{};
    const Contribution whole{p.row.data(), &alone}, share{p.row.data(), p.particle};
    kernels_.add_contributions({&whole, 1}, NodeSpan::size, 1, nothing, carried);
    kernels_.add_contributions({&share, 1}, NodeSpan::size, 1, nothing, contribution);
    return {.path = path_of(schemes_.tracer.entry(), p.start),
            .weight = number(p.particle->weight),
            .value = number(p.row[0]),
            .gradient_x = number(p.row[NodeSpan::size]),
            .gradient_y = number(p.row[2 * NodeSpan::size]),
            .cross = number(p.row[3 * NodeSpan::size]),
            .at_node = number(carried[0]),
            .contribution = number(contribution[0])};
}

Sum NodeStepper::particle_sum(const Particle& particle, const StencilParticle& found) const {
    const double to_x = -number(particle.offset.x), to_y = -number(particle.offset.y);
    Sum sum;
    sum.title = "x_s " + offset_name(particle.offset);
    sum.equation = "thesis eq. 4.3";
    sum.terms.push_back({"q_s", 1, found.value});
    if (schemes_.expansion() != Expansion::Value) {
        sum.equation = "thesis eq. 4.1, its bracket; q_s and ∂q: eq. 4.2–4.3";
        sum.units = "times x_i − x_s in cells; ∂q per cell";
        sum.terms.push_back({"∂q/∂x", to_x, found.gradient_x});
        sum.terms.push_back({"∂q/∂y", to_y, found.gradient_y});
    }
    if (schemes_.expansion() == Expansion::CrossTerm) {
        sum.equation += "; c_xy after sec. 6.1";
        sum.units += ", c_xy per cell²";
        sum.terms.push_back({"c_xy", to_x * to_y, found.cross});
    }
    sum.total = found.at_node;
    return sum;
}

Real NodeStepper::limited(LimitFn by, const Field& q, Index cell, Real first_order, Real value) const {
    CellPositions at{};
    at.at[0] = cell;
    Values first{}, values{};
    first[0] = first_order;
    values[0] = value;
    by(q, at.at, 1, first, values);
    return values[0];
}

Clamping NodeStepper::cut(const Field& q, Index cell, Real before, Real after) const {
    // What is beyond all numbers is clamped to the bounds.
    constexpr Real most = std::numeric_limits<Real>::max();
    Clamping cut;
    cut.low = number(limited(clamp_, q, cell, 0, -most));
    cut.high = number(limited(clamp_, q, cell, 0, most));
    cut.before = number(before);
    cut.after = number(after);
    return cut;
}

void NodeStepper::limit_base(const Field& q, NodeStep& step) const {
    if (kernels_.limit_base == nullptr) return;
    const Real before = step.value;
    step.value = limited(kernels_.limit_base, q, step.cell, step.first_order, before);
    step.sum.cut = cut(q, step.cell, before, step.value);
    step.sum.cut->by = std::string(schemes_.base.info().label);
    step.sum.cut->equation = thesis_part(schemes_.base.info().source);
}

void NodeStepper::limit(const Field& q, Index cell, Real first_order, Sum& sum, Real& value) const {
    if (schemes_.limiter->traits.idle) return;
    const Real before = value;
    value = limited(kernels_.limit, q, cell, first_order, before);
    sum.cut = cut(q, cell, before, value);
    sum.cut->by = "limiter: " + std::string(schemes_.limiter.info().label);
    const std::string_view clamp_source = schemes_.advector->traits.clamp_source;
    const bool as_advector = schemes_.limiter->traits.bounds && !clamp_source.empty();
    sum.cut->equation = as_advector ? std::string(clamp_source) : thesis_part(schemes_.limiter.info().source);
    if (schemes_.limiter->traits.falls_back) sum.cut->first_order = number(first_order);
}

}  // namespace whorl
