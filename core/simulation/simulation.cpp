#include "core/simulation/simulation.h"

#include <limits>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/stopwatch.h"

namespace whorl {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

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
    solvers_.advected.reset();
    solvers_.forget();
    experiment_ = &experiment(scene_.experiment);
    state_ = make_state(scene_);
    if (experiment_->start) experiment_->start(state_);
    if (experiment_->flow) experiment_->flow(0, state_.grid(), state_.velocity);
    if (!experiment_->flow) state_.boundary.enforce(state_.velocity);
    state_.fill_ghosts();
    state_.injected = totals(state_);
    set_scene(scene_);
    solvers_.projection.restore({}, state_.boundary, *pool_);
    measures_ = {};
    const double nothing = experiment_->flow ? unknown : 0;
    for (const StepOrder::Part& part : order().parts) measures_.add(part.phase, {0, nothing, nothing});
    measure(reducer_.flow(state_.velocity, state_.boundary, *pool_));
}

void Simulation::set_scene(const Scene& scene) {
    scene_ = scene;
    if (!(state_.grid() == scene.grid()) || state_.boundary.sides() != scene.sides) {
        const FlowSums before = reducer_.flow(state_.velocity, state_.boundary, *pool_);
        solvers_.advected.reset();
        solvers_.forget();
        state_ = resample(state_, scene);
        solvers_.projection.restore({}, state_.boundary, *pool_);
        resampled_ += reducer_.flow(state_.velocity, state_.boundary, *pool_) - before;
    }
    if (!exact_.same_shape(state_.density()) || !solvers_.next.velocity.u.same_shape(state_.velocity.u)) {
        solvers_.next.scalars.resize(state_.scalars.size());
        for_advected([&](FieldId id) { solvers_.next[id] = state_.boundary.field(id.info().site); });
        exact_ = state_.boundary.field(Site::Centre);
    }
    solvers_.velocity.set({scene.velocity, scene.dimensions, scene.seed});
    solvers_.scalars.set({scene.scalars, scene.dimensions, scene.seed});
    solvers_.projection.set_solver(scene.pressure, scene.tolerance);
}

void Simulation::apply(const Edit& edit) {
    // A given flow is the very one that moved the density.
    if (edit.verb->changes_walls || experiment_->flow) solvers_.advected.reset();
    solvers_.edited(whorl::apply(edit, state_, scene_));
}

void Simulation::set(const Scene& scene) {
    require_no_conflict(scene);
    set_scene(scene);
}

void Simulation::restore(const Checkpoint& checkpoint) {
    solvers_.advected.reset();
    state_ = checkpoint.state;
    set_scene(checkpoint.scene);
    measures_ = checkpoint.measures;
    resampled_ = checkpoint.resampled;
    solvers_.projection.restore(checkpoint.projection, state_.boundary, *pool_);
    solvers_.restore(checkpoint.advection);
}

std::uint64_t Simulation::memory_digest() const {
    return solvers_.velocity.memory_digest() * 31 + solvers_.scalars.memory_digest();
}

void Simulation::step() {
    const Stopwatch watch;
    const FlowSums flow = run(order());
    ++state_.step;
    state_.time += scene_.dt;
    measures_.step_ms = watch.ms();
    measure(flow);
    if (!reducer_.finite()) {
        throw NotFinite("step " + std::to_string(state_.step) + ": " + not_finite(state_) +
                        " is not a finite number");
    }
}

const StepOrder& Simulation::order() const {
    return experiment_->flow ? prescribed_order : *step_orders().all()[scene_.order];
}

FlowSums Simulation::run(const StepOrder& order) {
    const bool solved = experiment_->flow == nullptr;
    FlowSums flow{measures_.kinetic_energy, measures_.enstrophy};
    flow += resampled_;
    measures_.phases.clear();
    Dissipation dissipation;
    for (const StepOrder::Part& part : order.parts) {
        const Phase& phase = phases().find(part.phase);
        const double dt = part.share * scene_.dt;
        const Stopwatch watch;
        phase.run({scene_, *experiment_, state_, solvers_, measures_, *pool_, dt});
        PhaseShare did{watch.ms(), unknown, unknown};
        if (solved) {
            const FlowSums before = flow;
            flow = reducer_.flow(state_.velocity, state_.boundary, *pool_);
            did.energy = (flow - before).kinetic_energy;
            did.enstrophy = (flow - before).enstrophy;
            if (phase.dissipates) dissipation.add(did.energy, before.enstrophy, dt);
        }
        measures_.add(phase.key, did);
    }
    measures_.effective_viscosity = dissipation.viscosity();
    return solved ? flow : reducer_.flow(state_.velocity, state_.boundary, *pool_);
}

std::optional<LastAdvection> Simulation::last_advection() const {
    if (!solvers_.advected) return std::nullopt;
    const bool solved = experiment_->flow == nullptr;
    LastAdvection last{*solvers_.advected, &state_.boundary,
                       solved ? &solvers_.next.velocity : &state_.velocity};
    last.before.resize(fields().size());
    last.now.resize(fields().size());
    for_advected([&](FieldId id) {
        if (!solved && id != field::density) return;
        last.before[id.index()] = &solvers_.next[id];
        last.now[id.index()] = &state_[id];
    });
    return last;
}

bool Simulation::exact(Field& density) const {
    if (experiment_->exact == nullptr) return false;
    return experiment_->exact(state_.time, scene_.dt, state_.grid(), density);
}

void Simulation::measure(const FlowSums& flow) {
    reducer_.measure(state_, flow, scene_.dt, *pool_, measures_);
    measures_.errors = exact(exact_) ? errors(state_.density(), exact_, state_.boundary) : Errors{};
    resampled_ = {};
}

}  // namespace whorl
