#include "core/advection/advection.h"

namespace whorl {

void Advection::set(const TransportSetup& setup) {
    if (transport_ && setup == setup_) return;
    if (!transport_ || setup.schemes.advector != setup_.schemes.advector)
        transport_ = setup.schemes.advector->make();
    setup_ = setup;
    transport_->prepare(setup_);
}

void Advection::advect(std::span<const AdvectedField> fields, const AdvectionStep& step) {
    transport_->advect(fields, step);
    for (const AdvectedField& field : fields) step.boundary->fill(*field.to);
}

}  // namespace whorl
