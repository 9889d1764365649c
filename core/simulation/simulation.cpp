#include "core/simulation/simulation.h"

#include <limits>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/forces/buoyancy.h"
#include "core/forces/emitters.h"

namespace whorl {
namespace {

void require_no_conflict(const Scene& scene) {
    const std::string reason = conflict(scene);
    if (!reason.empty()) throw InputError(reason);
}

}  // namespace

Simulation::Simulation(Scene scene, Pool& pool) : scene_(std::move(scene)), pool_(&pool) {
    require_no_conflict(scene_);
    flush_denormals();
    restart();
}

void Simulation::restart() {
    advected_.reset();
    experiment_ = &experiment(scene_.experiment);
    state_ = make_state(scene_);
    if (experiment_->start) experiment_->start(state_);
    if (experiment_->flow) experiment_->flow(0, state_.grid(), state_.velocity);
    if (!experiment_->flow) state_.boundary.enforce(state_.velocity);
    state_.fill_ghosts();
    state_.injected = totals(state_);
    set_scene(scene_);
    projection_.restore({}, state_.boundary, *pool_);
    measures_ = {};
    measure(meter_.flow(state_.velocity, state_.boundary, *pool_));
}

void Simulation::set_scene(const Scene& scene) {
    scene_ = scene;
    if (!(state_.grid() == scene.grid()) ||
        state_.boundary.periodic() != (scene.sides == Sides::of<Periodic>())) {
        const FlowSums before = meter_.flow(state_.velocity, state_.boundary, *pool_);
        advected_.reset();
        state_ = resample(state_, scene);
        projection_.restore({}, state_.boundary, *pool_);
        resampled_ += meter_.flow(state_.velocity, state_.boundary, *pool_) - before;
    }
    if (!exact_.same_shape(state_.density()) || !next_.velocity.u.same_shape(state_.velocity.u)) {
        next_.scalars.resize(state_.scalars.size());
        for_advected([&](FieldId id) { next_[id] = state_.boundary.field(id.info().site); });
        exact_ = state_.boundary.field(Site::Centre);
    }
    velocity_advection_.set({scene.velocity, scene.dimensions, scene.seed});
    scalars_advection_.set({scene.scalars, scene.dimensions, scene.seed});
    projection_.set_solver(scene.pressure, scene.tolerance);
}

void Simulation::apply(const SmokeStroke& stroke) {
    if (experiment_->flow) advected_.reset();  // it pushes the very flow that moved the density
    whorl::apply(stroke, state_);
}

void Simulation::apply(const ObstacleStroke& stroke) {
    advected_.reset();
    whorl::apply(stroke, state_, scene_);
}

void Simulation::set(const Scene& scene) {
    require_no_conflict(scene);
    set_scene(scene);
}

void Simulation::restore(const Checkpoint& checkpoint) {
    advected_.reset();
    state_ = checkpoint.state;
    set_scene(checkpoint.scene);
    measures_ = checkpoint.measures;
    resampled_ = checkpoint.resampled;
    projection_.restore(checkpoint.projection, state_.boundary, *pool_);
}

void Simulation::step() {
    measures_.ms = {};
    FlowSums flow{measures_.kinetic_energy, measures_.enstrophy};
    {
        const ScopeTimer total(measures_.ms.total);
        if (experiment_->flow) {
            experiment_->flow(state_.time, state_.grid(), state_.velocity);
            state_.boundary.fill(state_.velocity);
            advect();
            flow = meter_.flow(state_.velocity, state_.boundary, *pool_);
        } else {
            flow += resampled_;
            add_forces();
            book(&PhaseChanges::forces, flow);
            if (scene_.order == StepOrders::of<ThesisOrder>()) {
                project();
                book(&PhaseChanges::projection, flow);
                advect();
                book(&PhaseChanges::advection, flow);
            } else {
                advect();
                book(&PhaseChanges::advection, flow);
                project();
                book(&PhaseChanges::projection, flow);
            }
        }
        ++state_.step;
        state_.time += scene_.dt;
    }
    measure(flow);
    if (!meter_.finite()) {
        throw NotFinite("step " + std::to_string(state_.step) + ": " + not_finite(state_) +
                        " is not a finite number");
    }
}

void Simulation::book(double PhaseChanges::*phase, FlowSums& flow) {
    const FlowSums before = flow;
    flow = meter_.flow(state_.velocity, state_.boundary, *pool_);
    const FlowSums change = flow - before;
    measures_.energy_changes.*phase = change.kinetic_energy;
    measures_.enstrophy_changes.*phase = change.enstrophy;
    if (phase == &PhaseChanges::advection)
        measures_.effective_viscosity =
            effective_viscosity(change.kinetic_energy, before.enstrophy, scene_.dt);
}

void Simulation::add_forces() {
    const ScopeTimer watch(measures_.ms.forces);
    apply_emitters(state_, scene_.emitters, scene_.dt);
    add_buoyancy(state_, scene_.alpha, scene_.beta, scene_.ambient, scene_.dt, *pool_);
    state_.boundary.enforce(state_.velocity);
    confinement_.add(state_, scene_.confinement, scene_.dt, *pool_);
    state_.boundary.enforce(state_.velocity);
}

void Simulation::project() {
    const ScopeTimer watch(measures_.ms.projection);
    const ProjectionReport report =
        projection_.project(state_.velocity, scene_.dt, state_.boundary, state_.pressure, *pool_);
    measures_.divergence_before = report.divergence_before;
    measures_.divergence_after = report.divergence_after;
    measures_.relative_divergence =
        report.largest_speed > 0 ? report.divergence_after * state_.grid().h / report.largest_speed : 0;
    measures_.pressure = report.solve;
    measures_.pressure.solver = report.solver;
    measures_.pressure_why_not = report.why_not;
    measures_.removed_mean = report.removed_mean;
}

void Simulation::advect() {
    const ScopeTimer watch(measures_.ms.advection);
    const bool solved = experiment_->flow == nullptr;
    // Fields that are advected by the same schemes go together, and share what they can. Where the flow is
    // given, only the density is advected.
    const std::size_t scalars = solved ? state_.scalars.size() : 1;
    moving_.clear();
    for (std::size_t k = 0; k < scalars; ++k) moving_.push_back({&state_.scalars[k], &next_.scalars[k]});
    if (solved) {
        moving_.push_back({&state_.velocity.u, &next_.velocity.u});
        moving_.push_back({&state_.velocity.v, &next_.velocity.v});
    }
    const std::span<const AdvectedField> all = moving_;
    const bool together = solved && scalars_advection_.schemes() == velocity_advection_.schemes();
    const AdvectionStep step{&state_.velocity, &state_.boundary, pool_, scene_.dt};
    scalars_advection_.advect(together ? all : all.first(scalars), step);
    if (solved) {
        if (!together) velocity_advection_.advect(all.last(2), step);
        std::swap(state_.velocity, next_.velocity);
        state_.boundary.enforce(state_.velocity);
    }
    for (std::size_t k = 0; k < scalars; ++k) std::swap(state_.scalars[k], next_.scalars[k]);
    advected_ = {scene_.velocity, scene_.scalars, scene_.dt, scene_.seed};
}

std::optional<LastAdvection> Simulation::last_advection() const {
    if (!advected_) return std::nullopt;
    const bool solved = experiment_->flow == nullptr;
    LastAdvection last{*advected_, &state_.boundary, solved ? &next_.velocity : &state_.velocity};
    last.before.resize(fields().size());
    last.now.resize(fields().size());
    for_advected([&](FieldId id) {
        if (!solved && id != field::density) return;
        last.before[id.index()] = &next_[id];
        last.now[id.index()] = &state_[id];
    });
    return last;
}

bool Simulation::exact(Field& density) const {
    if (experiment_->exact == nullptr) return false;
    return experiment_->exact(state_.time, scene_.dt, state_.grid(), density);
}

void Simulation::measure(const FlowSums& flow) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    meter_.measure(state_, flow, scene_.dt, *pool_, measures_);
    if (experiment_->flow) {
        measures_.energy_changes = {unknown, unknown, unknown};
        measures_.enstrophy_changes = measures_.energy_changes;
    }
    measures_.errors =
        exact(exact_) ? errors(state_.density(), exact_, state_.boundary) : Errors{unknown, unknown, unknown};
    resampled_ = {};
}

}  // namespace whorl
