#include "core/advection/advection.h"

namespace whorl {

void Advection::set(const TransportSetup& setup) {
    if (transport_ && setup == setup_) return;
    if (!transport_ || setup.schemes.advector != setup_.schemes.advector) {
        transport_ = setup.schemes.advector->make();
        forget();
    }
    setup_ = setup;
    if (!transport_->prepare(setup_)) forget();
}

void Advection::advect(std::span<const AdvectedField> fields, const AdvectionStep& step) {
    if (setup_.schemes.advector->traits.memory && seeded_ != fields.size()) {
        transport_->seed(fields, step);
        seeded_ = fields.size();
    }
    transport_->advect(fields, step);
    for (const AdvectedField& field : fields) step.boundary->fill(*field.to);
}

void Advection::edited(const CellRange& cells) {
    if (seeded_ != 0 && !cells.empty()) transport_->edited(cells);
}

TransportMemory Advection::memory() const {
    if (seeded_ == 0) return {};
    SavingArchive archive;
    transport_->archive(archive);
    return {seeded_, std::move(archive.saved)};
}

void Advection::restore(const TransportMemory& memory) {
    seeded_ = memory.fields;
    if (seeded_ == 0) return;
    RestoringArchive archive(memory.bytes);
    transport_->archive(archive);
}

std::uint64_t Advection::memory_digest() const {
    if (seeded_ == 0) return 0;
    DigestingArchive archive;
    transport_->archive(archive);
    return archive.value();
}

}  // namespace whorl
