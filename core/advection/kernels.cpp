#include "core/advection/kernels.h"

#include "core/advection/affine_loops.h"
#include "core/sampling/locate_loop.h"

namespace whorl {
namespace {

template <Expansion expansion, bool periodic>
void choose_affine(Kernels& kernels, Isa isa) {
    kernels.sample_particles = PerIsa<SampleParticlesFn, SampleParticlesLoop<expansion, periodic>>::pick(isa);
    kernels.add_contributions = PerIsa<AddContributionsFn, AddContributionsLoop<expansion>>::pick(isa);
}

template <bool periodic>
void choose_affine(Kernels& kernels, Expansion expansion, Isa isa) {
    switch (expansion) {
        case Expansion::Value:
            return choose_affine<Expansion::Value, periodic>(kernels, isa);
        case Expansion::Gradient:
            return choose_affine<Expansion::Gradient, periodic>(kernels, isa);
        case Expansion::CrossTerm:
            return choose_affine<Expansion::CrossTerm, periodic>(kernels, isa);
        case Expansion::None:
            return;
    }
}

template <bool periodic>
LocateFn locate_loop(Isa isa) {
    return PerIsa<LocateFn, LocateLoop<periodic>>::pick(isa);
}

}  // namespace

Kernels choose_kernels(const SchemeSet& s, bool periodic, Isa isa) {
    Kernels kernels{};
    kernels.trace = s.tracer->trace(periodic, isa);
    kernels.locate = periodic ? locate_loop<true>(isa) : locate_loop<false>(isa);
    kernels.sample = s.interpolation->sample(
        {.x_first = s.axis_order->x_first, .clamped = s.clamped, .periodic = periodic}, isa);
    kernels.sample_linear = linear.sample({.periodic = periodic}, isa);
    if (periodic) {
        choose_affine<true>(kernels, s.expansion(), isa);
    } else {
        choose_affine<false>(kernels, s.expansion(), isa);
    }
    kernels.limit = s.limiter->limit(isa);
    if (s.base->clamped) kernels.limit_base = clamp_limiter.limit(isa);
    return kernels;
}

}  // namespace whorl
