#include "core/inspect/limiter_map.h"

#include "core/inspect/explain.h"
#include "core/inspect/explainer.h"
#include "core/inspect/walls.h"

namespace whorl {
namespace {

/// The scheme whose whole step is the base step of a predictor-corrector.
SchemeSet base_of(SchemeSet schemes) {
    schemes.advector = *schemes.base->step;
    schemes.limiter = schemes.base->clamped ? clamp_limiter : no_limiter;
    return schemes;
}

class Marker {
  public:
    Marker(const LastAdvection& last, Pool& pool, Field& marks) : last_(last), pool_(pool), marks_(marks) {}

    void mark(const Field& q, const SchemeSet& schemes) {
        Advection advection;
        SchemeSet without = schemes;
        without.limiter = no_limiter;
        const std::span<const BasePass> passes =
            AdvectorExplanation::list().find(schemes.advector.key()).passes;
        if (passes.empty()) {
            without.clamped = false;
            return mark_difference(q, schemes, without, last_.setup.dt, advection);
        }
        mark_difference(q, schemes, without, last_.setup.dt, advection);
        const SchemeSet base = base_of(schemes);
        if (!base.clamped && base.limiter->traits.idle) return;
        const Workspace& work = *advection.workspace();
        for (const BasePass& pass : passes) {
            const Field& from = pass.field == BasePass::Of::Start     ? q
                                : pass.field == BasePass::Of::Forward ? work.forward[0]
                                                                      : work.corrected[0];
            mark_base(from, base, pass.direction * last_.setup.dt);
        }
    }

  private:
    void mark_base(const Field& q, const SchemeSet& base, double dt) {
        SchemeSet without = base;
        without.limiter = no_limiter;
        without.clamped = false;
        Advection advection;
        mark_difference(q, base, without, dt, advection);
    }

    /// @param advection takes the step `without`, and has its workspace when done
    void mark_difference(const Field& q, const SchemeSet& with, const SchemeSet& without, double dt,
                         Advection& advection) {
        if (with == without) {
            advect(q, without, dt, advection);
            return;
        }
        Advection limiting;
        const Field a = advect(q, with, dt, limiting);
        const Field b = advect(q, without, dt, advection);
        pool_.bands(q.height(), [&](int first, int last) {
            for (int j = first; j < last; ++j) {
                for (int i = 0; i < q.width(); ++i) {
                    if (a(i, j) != b(i, j)) marks_(i, j) = 1;
                }
            }
        });
    }

    Field advect(const Field& q, const SchemeSet& schemes, double dt, Advection& advection) {
        Field moved = last_.boundary->field(q.site());
        advection.set({schemes, last_.boundary->grid().dimensions(), last_.setup.seed});
        advection.advect(q, moved, {last_.velocity, last_.boundary, &pool_, dt});
        return moved;
    }

    const LastAdvection& last_;
    Pool& pool_;
    Field& marks_;
};

}  // namespace

int limiter_map(const LastAdvection& last, FieldId quantity, Pool& pool, Field& marks) {
    const Field* q = last.from(quantity);
    if (q == nullptr) {
        marks.set_all(0);
        return 0;
    }
    flush_denormals();
    marks = Field(q->width(), q->height(), q->site());
    if (!unexplained(last.setup.schemes(quantity)).empty()) return 0;
    Marker(last, pool, marks).mark(*q, last.setup.schemes(quantity));
    const WallRules walls(*last.boundary, q->site());
    int count = 0;
    for (int j = 0; j < q->height(); ++j) {
        for (int i = 0; i < q->width(); ++i) {
            if (!walls.free(i, j)) marks(i, j) = 0;
            count += marks(i, j) != 0 ? 1 : 0;
        }
    }
    return count;
}

}  // namespace whorl
