#include "core/advection/step.h"

#include <algorithm>

namespace whorl {

Pass::Pass(std::span<const AdvectedField> fields, int number) {
    for (const Site site : {Site::Centre, Site::FaceX, Site::FaceY}) {
        Group& group = groups_[count_];
        int seen = 0;
        for (const AdvectedField& field : fields) {
            if (field.from->site() != site) continue;
            if (seen++ / Group::max_fields == number) group.add(*field.from, *field.to);
        }
        if (group.count > 0) ++count_;
    }
}

int Step::most_rows(Groups groups) {
    int rows = 0;
    for (const Group& group : groups) rows = std::max(rows, group.shape().height());
    return rows;
}

void Step::departure(NodeSpan nodes, const Field& shape, Real direction, CellPositions& out) const {
    Displacements d;
    kernels.trace({velocity, shape.site()}, nodes, Vec2(0, 0), direction * dt, d.x, d.y);
    kernels.locate(shape, shape.site(), nodes, d.x, d.y, out);
}

void Step::plain_band(Groups groups, Real direction, int first, int last, Store finish) const {
    for (int j = first; j < last; ++j) {
        for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
            const Field& shape = groups[g].shape();
            if (j >= shape.height()) continue;
            for (int i = 0; i < shape.width(); i += NodeSpan::size) {
                const NodeSpan nodes{i, j, std::min(NodeSpan::size, shape.width() - i)};
                CellPositions at;
                GroupValues q, first_order;
                departure(nodes, shape, direction, at);
                const StepResult result{g, nodes, at, q, first_order};
                plain_span(groups[g], nodes, direction, result);
                finish(result);
            }
        }
    }
}

void Step::plain_span(const Group& group, NodeSpan nodes, Real direction, const StepResult& out) const {
    if (kernels.sample_particles == nullptr) {
        for (int f = 0; f < group.count; ++f) kernels.sample(*group.from[f], out.at, nodes.count, out.q[f]);
        return;
    }
    GroupValues sum{};
    for (int f = 0; f < group.count; ++f) {
        kernels.sample_linear(*group.from[f], out.at, nodes.count, out.first_order[f]);
    }
    for (const Particle& particle : particles) {
        if (particle.offset == Vec2(0, 0)) continue;  // its contribution is a difference from itself
        const Site site = group.shape().site();
        Displacements d;
        alignas(64) Real samples[Group::max_fields * ParticleSamples::rows * NodeSpan::size];
        kernels.trace({velocity, site}, nodes, particle.offset, direction * dt, d.x, d.y);
        kernels.sample_particles(group.sources(), site, nodes, d.x, d.y, {samples, NodeSpan::size});
        for (int f = 0; f < group.count; ++f) {
            const Contribution one{samples + f * ParticleSamples::rows * NodeSpan::size, &particle};
            kernels.add_contributions({&one, 1}, NodeSpan::size, nodes.count, out.first_order[f], sum[f]);
        }
    }
    for (int f = 0; f < group.count; ++f) {
        for (int k = 0; k < nodes.count; ++k) out.q[f][k] = out.first_order[f][k] + sum[f][k];
    }
}

void Workspace::shape_like(const Group& group) {
    const Field& shape = group.shape();
    for (int f = 0; f < group.count; ++f) {
        for (Field* field : {&forward[f], &corrected[f]}) {
            if (!field->same_shape(shape)) *field = Field(shape.width(), shape.height(), shape.site());
        }
    }
    cells.resize(static_cast<std::size_t>(shape.width()) * shape.height() + NodeSpan::size);
}

}  // namespace whorl
