// THE registry: every scheme that Whorl knows, a line each. The first of a list is its default.
#pragma once

#include "core/advection/aslam.h"
#include "core/advection/bfecc.h"
#include "core/advection/limiters.h"
#include "core/advection/maccormack.h"
#include "core/advection/semi_lagrangian.h"
#include "core/advection/stencils.h"
#include "core/advection/weights.h"
#include "core/interpolation/axis_order.h"
#include "core/interpolation/b_spline.h"
#include "core/interpolation/bicubic.h"
#include "core/interpolation/bridson.h"
#include "core/interpolation/catmull_rom.h"
#include "core/interpolation/fritsch_carlson.h"
#include "core/interpolation/linear.h"
#include "core/interpolation/monotone_catmull_rom.h"
#include "core/tracing/euler.h"
#include "core/tracing/midpoint.h"
#include "core/tracing/rk3.h"
#include "core/tracing/rk4.h"

namespace whorl {

using Advectors = SchemeList<SemiLagrangian,  //
                             MacCormack,      //
                             Bfecc,           //
                             Aslam,           //
                             AslamZero,       //
                             AslamBilinear>;

/// What a predictor-corrector takes as its step A: the step of the advector that it names as `Whole`.
using Bases = SchemeList<SemiLagrangian,  //
                         Aslam,           //
                         AslamClamped,    //
                         AslamBilinear>;

using Interpolations = SchemeList<Linear,              //
                                  CatmullRom,          //
                                  MonotoneCatmullRom,  //
                                  Bridson,             //
                                  FritschCarlson,      //
                                  FritschCarlsonSquare,
                                  BSpline,  //
                                  Bicubic>;

using AxisOrders = SchemeList<XFirst, YFirst>;

using Tracers = SchemeList<Midpoint,  //
                           Euler,     //
                           Rk3,       //
                           Rk4>;

using Stencils = SchemeList<Chessboard,   //
                            Manhattan,    //
                            Subsampling,  //
                            Jittered>;

using Weights = SchemeList<SphWeights,      //
                           UniformWeights,  //
                           GaussianWeights>;

using Limiters = SchemeList<ClampLimiter,   //
                            RevertLimiter,  //
                            NoLimiter>;

/// Everything that says how a quantity is advected.
struct SchemeSet {
    Advectors::Id advector;
    Bases::Id base;
    Interpolations::Id interpolation;
    bool clamped = false;
    AxisOrders::Id axis_order;
    Tracers::Id tracer;
    Stencils::Id stencil;
    int zeta = 2;
    Weights::Id weights;
    Limiters::Id limiter;

    static constexpr int max_zeta = 4;

    bool predictor_corrector() const {
        return Advectors::dispatch(advector,
                                   []<class A>(std::type_identity<A>) { return A::predictor_corrector; });
    }
    /// What the particles of the step, or of a predictor-corrector's base step, carry.
    Expansion expansion() const {
        const auto of = []<class A>(std::type_identity<A>) { return A::expansion; };
        return predictor_corrector() ? Bases::dispatch(base, of) : Advectors::dispatch(advector, of);
    }
    bool seeded() const {
        return Stencils::dispatch(stencil, []<class S>(std::type_identity<S>) { return S::seeded; });
    }
    bool x_first() const {
        return AxisOrders::dispatch(axis_order, []<class A>(std::type_identity<A>) { return A::x_first; });
    }
    InterpolationTraits interpolation_traits() const {
        return Interpolations::dispatch(interpolation,
                                        []<class I>(std::type_identity<I>) { return I::traits; });
    }
    /// Whether the step is of the ASLAM family, which samples linearly.
    bool affine() const { return expansion() != Expansion::None; }
    bool operator==(const SchemeSet&) const = default;
};

}  // namespace whorl
