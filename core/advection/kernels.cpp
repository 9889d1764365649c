// The sole place where the loops of interpolation, tracers and limiters are instantiated.
#include "core/advection/advect.h"
#include "core/advection/affine_loops.h"
#include "core/advection/sampling_loops.h"

namespace whorl {
namespace {

/// Turns a run-time truth into a template argument.
template <class F>
auto with_bool(bool value, F&& f) {
    return value ? f(std::true_type{}) : f(std::false_type{});
}

SampleFn choose_sample(const SchemeSet& s, bool periodic, Isa isa) {
    return Interpolations::dispatch(s.interpolation, [&]<class I>(std::type_identity<I>) {
        return with_bool(s.x_first(), [&]<class X>(X) {
            return with_bool(s.clamped, [&]<class C>(C) {
                return with_bool(periodic, [&]<class P>(P) {
                    return PerIsa<SampleFn, SampleLoop<I, X::value, C::value, P::value>>::pick(isa);
                });
            });
        });
    });
}

template <Expansion expansion>
void choose_affine(Kernels& kernels, bool periodic, Isa isa) {
    kernels.carry = with_bool(
        periodic, [&]<class P>(P) { return PerIsa<CarryFn, CarryLoop<expansion, P::value>>::pick(isa); });
    kernels.gather = PerIsa<GatherFn, GatherLoop<expansion>>::pick(isa);
}

}  // namespace

Kernels choose_kernels(const SchemeSet& s, bool periodic, Isa isa) {
    Kernels kernels{};
    with_bool(periodic, [&]<class P>(P) {
        kernels.trace = Tracers::dispatch(s.tracer, [&]<class T>(std::type_identity<T>) {
            return PerIsa<TraceFn, TraceLoop<T, P::value>>::pick(isa);
        });
        kernels.locate = PerIsa<LocateFn, LocateLoop<P::value>>::pick(isa);
        kernels.sample_linear = PerIsa<SampleFn, SampleLoop<Linear, true, false, P::value>>::pick(isa);
    });
    kernels.sample = choose_sample(s, periodic, isa);
    switch (s.expansion()) {
        case Expansion::Value:
            choose_affine<Expansion::Value>(kernels, periodic, isa);
            break;
        case Expansion::Gradient:
            choose_affine<Expansion::Gradient>(kernels, periodic, isa);
            break;
        case Expansion::CrossTerm:
            choose_affine<Expansion::CrossTerm>(kernels, periodic, isa);
            break;
        case Expansion::None:
            break;
    }
    kernels.limit = Limiters::dispatch(
        s.limiter, [&]<class L>(std::type_identity<L>) { return PerIsa<LimitFn, LimitLoop<L>>::pick(isa); });
    if (Bases::dispatch(s.base, []<class B>(std::type_identity<B>) { return B::clamps_base; })) {
        kernels.limit_base = PerIsa<LimitFn, LimitLoop<ClampLimiter>>::pick(isa);
    }
    return kernels;
}

}  // namespace whorl
