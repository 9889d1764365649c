// A transport that remembers particles: a toy.
#include "tests/extend/toys.h"

#include <cmath>

#include "core/advection/transport.h"
#include "core/sampling/cell.h"

namespace whorl::test {
namespace {

/// One particle a cell, which carries the fields' values along; nodes take the mean of those that are near,
/// and keep what they hold where there is none. What others changed since reaches the particles as the
/// difference from what was written last.
class DriftingParticles final : public Transport {
  public:
    bool prepare(const TransportSetup& setup) override {
        const bool same = setup.seed == seed_;
        seed_ = setup.seed;
        return same;
    }
    void seed(std::span<const AdvectedField> fields, const AdvectionStep& step) override {
        const Grid& grid = step.boundary->grid();
        positions_.clear();
        for (int j = 0; j < grid.ny; ++j) {
            for (int i = 0; i < grid.nx; ++i) {
                const auto shift = static_cast<Real>((i * 7 + j * 3 + static_cast<int>(seed_)) % 5) / 10;
                positions_.emplace_back(static_cast<Real>(i) + Real(0.3) + shift,
                                        static_cast<Real>(j) + Real(0.5));
            }
        }
        written_.clear();
        values_.clear();
        for (const AdvectedField& field : fields) {
            written_.push_back(*field.from);
            for (const Vec2& at : positions_) values_.push_back(value(*field.from, at));
        }
    }

    void advect(std::span<const AdvectedField> fields, const AdvectionStep& step) override {
        const std::size_t count = positions_.size();
        const Grid& grid = step.boundary->grid();
        const auto cells = static_cast<Real>(step.dt / grid.h);
        step.pool->bands(static_cast<int>(count), [&](int first, int last) {
            for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p) {
                Vec2& at = positions_[p];
                for (std::size_t f = 0; f < fields.size(); ++f)
                    values_[f * count + p] += value(*fields[f].from, at) - value(written_[f], at);
                at += cells * Vec2(value(step.velocity->u, at), value(step.velocity->v, at));
                at.x = std::clamp(at.x, Real(0), static_cast<Real>(grid.nx) - Real(0.001));
                at.y = std::clamp(at.y, Real(0), static_cast<Real>(grid.ny) - Real(0.001));
            }
        });
        for (std::size_t f = 0; f < fields.size(); ++f) {
            deposit(&values_[f * count], *fields[f].from, *fields[f].to);
            written_[f] = *fields[f].to;
            step.boundary->fill(written_[f]);
        }
    }

    void archive(Archive& a) override {
        a("positions", positions_);
        a("values", values_);
        std::size_t fields = written_.size();
        a("number of fields", fields);
        written_.resize(fields);
        for (Field& field : written_) archive_field(a, "written", field);
    }

  private:
    /// @param at cells from the domain's corner
    static Real value(const Field& q, Vec2 at) {
        const Real x = at.x - static_cast<Real>(offset_x(q.site()));
        const Real y = at.y - static_cast<Real>(offset_y(q.site()));
        const Real i = std::floor(x), j = std::floor(y);
        const auto a = static_cast<int>(i), b = static_cast<int>(j);
        return lerp(lerp(q(a, b), q(a + 1, b), x - i), lerp(q(a, b + 1), q(a + 1, b + 1), x - i), y - j);
    }
    /// In the order of the particles, so that sums do not depend on threads.
    void deposit(const Real* values, const Field& before, Field& to) {
        sums_.assign(static_cast<std::size_t>(to.width()) * static_cast<std::size_t>(to.height()),
                     Vec2(0, 0));
        for (std::size_t p = 0; p < positions_.size(); ++p) {
            const auto node = [](Real at, double offset, int n) {
                return std::clamp(static_cast<int>(std::lround(static_cast<double>(at) - offset)), 0, n - 1);
            };
            const int i = node(positions_[p].x, offset_x(to.site()), to.width());
            const int j = node(positions_[p].y, offset_y(to.site()), to.height());
            sums_[static_cast<std::size_t>(j * to.width() + i)] += Vec2(values[p], 1);
        }
        for (int j = 0; j < to.height(); ++j) {
            for (int i = 0; i < to.width(); ++i) {
                const Vec2& sum = sums_[static_cast<std::size_t>(j * to.width() + i)];
                to(i, j) = sum.y > 0 ? sum.x / sum.y : before(i, j);
            }
        }
    }

    std::uint64_t seed_ = 0;
    std::vector<Vec2> positions_;  ///< cells
    std::vector<Real> values_;     ///< field by field
    std::vector<Field> written_;
    std::vector<Vec2> sums_;  ///< of one deposit
};

}  // namespace

constinit const Advector drifting_particles{
    .info{"drifting-particles", "Drifting particles", "a test", "Remembers particles."},
    .traits{.memory = true},
    .make = []() -> std::unique_ptr<Transport> { return std::make_unique<DriftingParticles>(); }};

}  // namespace whorl::test
