// A choice of schemes: everything that says how a quantity is advected.
#pragma once

#include "core/advection/advector.h"
#include "core/interpolation/axis_order.h"
#include "core/interpolation/interpolation.h"
#include "core/limiters/limiter.h"
#include "core/stencils/stencil_shape.h"
#include "core/stencils/weight_kernel.h"
#include "core/tracing/tracer.h"

namespace whorl {

struct SchemeSet {
    Id<Advector> advector;
    Id<BaseScheme> base;
    Id<Interpolation> interpolation;
    bool clamped = false;
    Id<AxisOrder> axis_order;
    Id<Tracer> tracer;
    Id<StencilShape> stencil;
    int zeta = 2;
    Id<WeightKernel> weights;
    Id<Limiter> limiter;

    static constexpr int max_zeta = 4;

    bool predictor_corrector() const { return advector->traits.base_step; }
    /// The advector whose particles the step has: its own, or those of a predictor-corrector's base step.
    const Advector& stepper() const { return predictor_corrector() ? *base->step : advector.entry(); }
    /// What those particles carry.
    Expansion expansion() const { return stepper().traits.expansion; }
    /// Whether the step is of the ASLAM family, which samples linearly.
    bool affine() const { return expansion() != Expansion::None; }
    /// The name of what makes the step's particles.
    const SchemeInfo& step_info() const { return predictor_corrector() ? base.info() : advector.info(); }
    bool operator==(const SchemeSet&) const = default;
};

}  // namespace whorl
