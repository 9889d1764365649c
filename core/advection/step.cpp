#include "core/advection/step.h"

namespace whorl {

void Step::departure(Run run, const Field& shape, Real direction, Places& out) const {
    Displacements d;
    kernels.trace(flow, run, Vec2(0, 0), direction * dt, d);
    kernels.locate(shape, run, d, out);
}

void Step::base(Run run, const Group& group, const Places& at, Real direction, GroupValues& out,
                GroupValues& first_order) const {
    if (kernels.share == nullptr) {
        for (int f = 0; f < group.count; ++f) {
            kernels.sample(*group.from[f], at, run.count, out[f]);
            std::copy_n(out[f], run.count, first_order[f]);
        }
        return;
    }
    GroupValues sum{};
    for (int f = 0; f < group.count; ++f)
        kernels.sample_linear(*group.from[f], at, run.count, first_order[f]);
    for (const Particle& particle : particles) {
        if (particle.offset == Vec2(0, 0)) continue;  // its share is a difference from itself
        Displacements d;
        Places from;
        kernels.trace(flow, run, particle.offset, direction * dt, d);
        kernels.locate(group.shape(), run, d, from);
        for (int f = 0; f < group.count; ++f) {
            kernels.share(*group.from[f], from, run.count, particle, first_order[f], sum[f]);
        }
    }
    for (int f = 0; f < group.count; ++f) {
        for (int k = 0; k < run.count; ++k) out[f][k] = first_order[f][k] + sum[f][k];
    }
}

void Workspace::shape_like(const Group& group) {
    const Field& shape = group.shape();
    for (int f = 0; f < group.count; ++f) {
        for (Field* field : {&forward[f], &corrected[f]}) {
            if (!field->same_shape(shape)) *field = Field(shape.width(), shape.height(), shape.site());
        }
    }
}

}  // namespace whorl
