// A transport that remembers what each node has held: a toy.
#include "tests/extend/toys.h"

#include "core/advection/transport.h"

namespace whorl::test {
namespace {

/// The mean of a semi-Lagrangian step and of all that the node has held since it was seeded or edited.
class RunningMean final : public Transport {
  public:
    bool prepare(const TransportSetup& setup) override {
        TransportSetup base = setup;
        base.schemes.advector = Id<Advector>("semi-lagrangian");
        step_->prepare(base);
        return true;
    }
    void seed(std::span<const AdvectedField> fields, const AdvectionStep&) override {
        means_.clear();
        for (const AdvectedField& field : fields) means_.push_back(*field.from);
        steps_ = 1;
        edited_.clear();
    }
    void edited(const CellRange& cells) override { edited_.push_back(cells); }

    void advect(std::span<const AdvectedField> fields, const AdvectionStep& step) override {
        for (const CellRange& cells : edited_) {
            for (std::size_t f = 0; f < fields.size(); ++f) copy(*fields[f].from, cells, means_[f]);
        }
        edited_.clear();
        step_->advect(fields, step);
        ++steps_;
        for (std::size_t f = 0; f < fields.size(); ++f) {
            Field& mean = means_[f];
            Field& to = *fields[f].to;
            step.pool->bands(to.height(), [&](int first, int last) {
                for (int j = first; j < last; ++j) {
                    for (int i = 0; i < to.width(); ++i) {
                        mean(i, j) += (to(i, j) - mean(i, j)) / static_cast<Real>(steps_);
                        to(i, j) = (to(i, j) + mean(i, j)) / 2;
                    }
                }
            });
        }
    }

    void archive(Archive& a) override {
        a("steps", steps_);
        std::size_t count = means_.size();
        a("number of means", count);
        means_.resize(count);
        for (Field& mean : means_) archive_field(a, "mean", mean);
        std::size_t edits = edited_.size();
        a("number of edits", edits);
        edited_.resize(edits);
        for (CellRange& cells : edited_) {
            for (int* part : {&cells.begin_i, &cells.begin_j, &cells.end_i, &cells.end_j}) a("edited", *part);
        }
    }

  private:
    static void copy(const Field& from, const CellRange& cells, Field& to) {
        for (int j = cells.begin_j; j < std::min(cells.end_j + 1, to.height()); ++j) {
            for (int i = cells.begin_i; i < std::min(cells.end_i + 1, to.width()); ++i) to(i, j) = from(i, j);
        }
    }

    std::unique_ptr<Transport> step_ = Id<Advector>("semi-lagrangian")->make();
    std::vector<Field> means_;
    int steps_ = 0;
    std::vector<CellRange> edited_;
};

}  // namespace

constinit const Advector running_mean{
    .info{"running-mean", "Running mean", "a test", "Remembers what each node has held."},
    .traits{.memory = true},
    .make = []() -> std::unique_ptr<Transport> { return std::make_unique<RunningMean>(); }};

}  // namespace whorl::test
