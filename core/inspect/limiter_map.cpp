#include "core/inspect/limiter_map.h"

#include "core/advection/advect.h"
#include "core/inspect/walls.h"

namespace whorl {
namespace {

/// The scheme whose whole step is the base step of a predictor-corrector.
SchemeSet base_of(SchemeSet schemes) {
    const bool clamps =
        Bases::dispatch(schemes.base, []<class B>(std::type_identity<B>) { return B::clamps_base; });
    schemes.advector = Bases::dispatch(
        schemes.base, []<class B>(std::type_identity<B>) { return Advectors::of<typename B::Whole>(); });
    schemes.limiter = clamps ? Limiters::of<ClampLimiter>() : Limiters::of<NoLimiter>();
    return schemes;
}

class Marker {
  public:
    Marker(const LastAdvection& last, Pool& pool, Field& marks) : last_(last), pool_(pool), marks_(marks) {}

    void mark(const Field& q, const SchemeSet& schemes) {
        Mover mover;
        SchemeSet without = schemes;
        without.limiter = Limiters::of<NoLimiter>();
        if (!schemes.predictor_corrector()) {
            without.clamped = false;
            return mark_difference(q, schemes, without, last_.setup.dt, mover);
        }
        mark_difference(q, schemes, without, last_.setup.dt, mover);
        const SchemeSet base = base_of(schemes);
        if (!base.clamped && base.limiter == Limiters::of<NoLimiter>()) return;
        const Workspace& way = mover.workspace(0);
        mark_base(q, base, last_.setup.dt);
        mark_base(way.forward[0], base, -last_.setup.dt);
        if (schemes.advector == Advectors::of<Bfecc>()) mark_base(way.corrected[0], base, last_.setup.dt);
    }

  private:
    void mark_base(const Field& q, const SchemeSet& base, double dt) {
        SchemeSet without = base;
        without.limiter = Limiters::of<NoLimiter>();
        without.clamped = false;
        Mover mover;
        mark_difference(q, base, without, dt, mover);
    }

    /// @param mover takes the step `without`, and has its way there when done
    void mark_difference(const Field& q, const SchemeSet& with, const SchemeSet& without, double dt,
                         Mover& mover) {
        if (with == without) {
            advect(q, without, dt, mover);
            return;
        }
        Mover limiting;
        const Field a = advect(q, with, dt, limiting);
        const Field b = advect(q, without, dt, mover);
        pool_.bands(q.height(), [&](int first, int last) {
            for (int j = first; j < last; ++j) {
                for (int i = 0; i < q.width(); ++i) {
                    if (a(i, j) != b(i, j)) marks_(i, j) = 1;
                }
            }
        });
    }

    Field advect(const Field& q, const SchemeSet& schemes, double dt, Mover& mover) {
        Field moved = last_.boundary->field(q.site());
        mover.set(schemes, last_.boundary->grid().dimensions(), last_.setup.seed);
        mover.advect(q, moved, *last_.velocity, dt, *last_.boundary, pool_);
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
