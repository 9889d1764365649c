#include "core/session/snapshot.h"

#include <algorithm>
#include <cmath>

#include "core/inspect/explain.h"
#include "core/scene/digest.h"

namespace whorl {
namespace {

/// The explanation of the node that is nearest to a point.
Explanation explained(const LastAdvection& last, const Watch::Node& node, Pool& pool) {
    const Field& field = *last.from(node.quantity);
    const double h = last.boundary->grid().h;
    const auto nearest = [h](double at, double offset, int count) {
        return std::clamp(static_cast<int>(std::lround(at / h - offset)), 0, count - 1);
    };
    return explain(last, node.quantity, nearest(node.at.x, offset_x(field.site()), field.width()),
                   nearest(node.at.y, offset_y(field.site()), field.height()), pool);
}

}  // namespace

void take_snapshot(const Lane& lane, Pool& pool, Snapshot& out, const std::optional<Watch::Node>& node) {
    const Simulation& simulation = lane.simulation();
    const State& state = simulation.state();
    out.scene = simulation.scene();
    out.failure = lane.failure();
    out.measures = simulation.measures();
    out.state = state;
    out.memory = simulation.memory_digest();
    if (!out.exact.same_shape(state.density())) out.exact = state.boundary.field(Site::Centre);
    out.has_exact = simulation.exact(out.exact);
    out.explanation.reset();
    out.watched = node;
    if (!node) return;
    const auto last = simulation.last_advection();
    if (!last || last->from(node->quantity) == nullptr) return;
    if (unexplained(last->setup.schemes(node->quantity)).empty())
        out.explanation = explained(*last, *node, pool);
}

void take_snapshot(const Session& session, const SessionSnapshot& last, Pool& pool, SessionSnapshot& out,
                   const std::optional<Watch::Node>& node) {
    out.setup = session.setup();
    out.step = session.step_number();
    out.last_step = session.last_step();
    out.complete = session.complete();
    out.time = session.time();
    out.lanes.resize(session.lane_count());
    out.ids.resize(session.lane_count());
    for (std::size_t k = 0; k < session.lane_count(); ++k) {
        Snapshot& lane = out.lanes[k];
        out.ids[k] = session.id(k);
        const auto before = std::find(last.ids.begin(), last.ids.end(), out.ids[k]);
        if (session.lane(k).failure() && before != last.ids.end()) {
            lane = last.lanes[static_cast<std::size_t>(before - last.ids.begin())];
            lane.failure = session.lane(k).failure();
        } else {
            take_snapshot(session.lane(k), pool, lane, node);
            lane.measures = session.measures(k);
            if (const LimiterMasks* limits = session.limits(k)) {
                lane.limits = *limits;
            } else {
                lane.limits.reset();
            }
        }
    }
}

std::uint64_t SessionSnapshot::digest() const {
    Digest digest;
    for (const Snapshot& lane : lanes) digest.add(lane.state, lane.memory);
    return digest.value();
}

}  // namespace whorl
