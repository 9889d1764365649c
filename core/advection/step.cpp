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

void Step::departure(Run run, const Field& shape, Real direction, Places& out) const {
    Displacements d;
    kernels.trace({velocity, shape.site()}, run, Vec2(0, 0), direction * dt, d.x, d.y);
    kernels.locate(shape, shape.site(), run, d.x, d.y, out);
}

void Step::plain_band(Groups groups, Real direction, int first, int last, Finish finish) const {
    for (int j = first; j < last; ++j) {
        for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
            const Field& shape = groups[g].shape();
            if (j >= shape.height()) continue;
            for (int i = 0; i < shape.width(); i += Run::size) {
                const Run run{i, j, std::min(Run::size, shape.width() - i)};
                Places at;
                GroupValues q, first_order;
                departure(run, shape, direction, at);
                const Stepped result{g, run, at, q, first_order};
                plain_run(groups[g], run, direction, result);
                finish(result);
            }
        }
    }
}

void Step::plain_run(const Group& group, Run run, Real direction, const Stepped& out) const {
    if (kernels.carry == nullptr) {
        for (int f = 0; f < group.count; ++f) kernels.sample(*group.from[f], out.at, run.count, out.q[f]);
        return;
    }
    GroupValues sum{};
    for (int f = 0; f < group.count; ++f) {
        kernels.sample_linear(*group.from[f], out.at, run.count, out.first_order[f]);
    }
    for (const Particle& particle : particles) {
        if (particle.offset == Vec2(0, 0)) continue;  // its share is a difference from itself
        const Site site = group.shape().site();
        Displacements d;
        alignas(64) Real carried[Group::max_fields * Carried::rows * Run::size];
        kernels.trace({velocity, site}, run, particle.offset, direction * dt, d.x, d.y);
        kernels.carry(group.sources(), site, run, d.x, d.y, {carried, Run::size});
        for (int f = 0; f < group.count; ++f) {
            const Share share{carried + f * Carried::rows * Run::size, &particle};
            kernels.gather({&share, 1}, Run::size, run.count, out.first_order[f], sum[f]);
        }
    }
    for (int f = 0; f < group.count; ++f) {
        for (int k = 0; k < run.count; ++k) out.q[f][k] = out.first_order[f][k] + sum[f][k];
    }
}

void Workspace::shape_like(const Group& group) {
    const Field& shape = group.shape();
    for (int f = 0; f < group.count; ++f) {
        for (Field* field : {&forward[f], &corrected[f]}) {
            if (!field->same_shape(shape)) *field = Field(shape.width(), shape.height(), shape.site());
        }
    }
    cells.resize(static_cast<std::size_t>(shape.width()) * shape.height() + Run::size);
}

}  // namespace whorl
