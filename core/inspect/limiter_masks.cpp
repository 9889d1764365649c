#include "core/inspect/limiter_masks.h"

#include "core/inspect/explain.h"
#include "core/inspect/limiter_map.h"

namespace whorl {

void mark_limits(const LastAdvection& last, Pool& pool, LimiterMasks& marks) {
    marks.counts = {};
    const int density = limiter_map(last, field::density, pool, marks.density);
    if (unexplained(last.setup.scalars).empty()) marks.counts.density = density;
    if (!marks.velocity.same_shape(marks.density)) marks.velocity = marks.density;
    marks.velocity.set_all(0);
    if (last.from(field::u) == nullptr) return;
    Field u, v;
    const int velocity = limiter_map(last, field::u, pool, u) + limiter_map(last, field::v, pool, v);
    if (unexplained(last.setup.velocity).empty()) marks.counts.velocity = velocity;
    for (int j = 0; j < marks.velocity.height(); ++j) {
        for (int i = 0; i < marks.velocity.width(); ++i)
            marks.velocity(i, j) = (u(i, j) + u(i + 1, j) + v(i, j) + v(i, j + 1)) * Real(0.25);
    }
}

}  // namespace whorl
