#include "core/advection/kernels.h"

#include "core/advection/affine_loops.h"
#include "core/sampling/locate_loop.h"

namespace whorl {
namespace {

template <Expansion expansion>
void choose_affine(Kernels& kernels, Wraps wraps, Isa isa) {
    kernels.sample_particles = with_wraps(wraps, [&]<class X, class Y>(X, Y) {
        return PerIsa<SampleParticlesFn, SampleParticlesLoop<expansion, X::value, Y::value>>::pick(isa);
    });
    kernels.add_contributions = PerIsa<AddContributionsFn, AddContributionsLoop<expansion>>::pick(isa);
}

void choose_affine(Kernels& kernels, Expansion expansion, Wraps wraps, Isa isa) {
    switch (expansion) {
        case Expansion::Value:
            return choose_affine<Expansion::Value>(kernels, wraps, isa);
        case Expansion::Gradient:
            return choose_affine<Expansion::Gradient>(kernels, wraps, isa);
        case Expansion::CrossTerm:
            return choose_affine<Expansion::CrossTerm>(kernels, wraps, isa);
        case Expansion::None:
            return;
    }
}

}  // namespace

Kernels choose_kernels(const SchemeSet& s, Wraps wraps, Isa isa) {
    Kernels kernels{};
    kernels.trace = s.tracer->trace(wraps, isa);
    kernels.locate = with_wraps(wraps, [&]<class X, class Y>(X, Y) {
        return PerIsa<LocateFn, LocateLoop<X::value, Y::value>>::pick(isa);
    });
    kernels.sample = s.interpolation->sample(
        {.x_first = s.axis_order->x_first, .clamped = s.clamped, .wraps = wraps}, isa);
    kernels.sample_linear = linear.sample({.wraps = wraps}, isa);
    choose_affine(kernels, s.expansion(), wraps, isa);
    kernels.limit = s.limiter->limit(isa);
    if (s.base->clamped) kernels.limit_base = clamp_limiter.limit(isa);
    return kernels;
}

}  // namespace whorl
