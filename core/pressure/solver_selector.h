// Which pressure solver acts while the walls change.
#pragma once

#include <future>
#include <memory>

#include "core/pressure/solver.h"

namespace whorl {

/// Keeps the chosen solver prepared for the boundary, or another one in its place: where the chosen one is
/// not offered, and, if it is slow to prepare, from the projection at which walls are painted until they have
/// been at rest for a while. It is then prepared on a thread of its own and takes over a fixed number of
/// projections later, waited for if need be: when a solver acts depends on the commands alone, so that a
/// replay gives the same bits.
class SolverSelector {
  public:
    /// Projections without a change of the walls after which the chosen solver is prepared: a pause in
    /// painting.
    static constexpr int projections_at_rest = 15;
    /// Projections that its preparation is given, for a number of cells: about LDLT's factorisation at 60 a
    /// second.
    static int projections_to_prepare(const Grid& grid);

    /// The solver by its index in pressure_solvers(), to be prepared at the next projection.
    void choose(std::size_t index);
    /// A projection of an unchanged boundary, the same domain with other walls, or another domain.
    enum class Change { None, Walls, Domain };
    /// To be called once a projection, before solver().
    void follow(const Boundary& boundary, Change change, Pool& pool);

    /// Which solver the next projection of an unchanged boundary will use.
    enum class Phase { Fresh, Ready, Painted };  ///< none prepared yet, the chosen one, one in its place
    struct Memory {
        Phase phase = Phase::Fresh;
        int at_rest = 0;  ///< projections since the walls were painted
    };
    Memory memory() const {
        return {!prepared_ ? Phase::Fresh : returns_ ? Phase::Painted : Phase::Ready, at_rest_};
    }
    /// Goes on from a memory of the same choice.
    /// @param same  whether this boundary is the one that was last followed
    void restore(const Memory& memory, const Boundary& boundary, bool same, Pool& pool);

    PressureSolver& solver() { return *(standing_in_ ? stand_in_ : chosen_); }
    /// Why another solver than the chosen one acts; empty if it does not.
    std::string_view unsupported_reason() const {
        return standing_in_ ? unsupported_reason_ : std::string_view();
    }

  private:
    const PressureSolverEntry& entry() const { return pressure_solvers()[index_]; }
    void stand_in(const Boundary& boundary, std::string_view unsupported_reason, Pool& pool);
    void prepare_later(const Boundary& boundary);

    std::size_t index_ = 0;
    std::unique_ptr<PressureSolver> chosen_, stand_in_;
    bool prepared_ = false;  ///< whether any solver is, since the choice
    bool standing_in_ = false;
    std::string_view unsupported_reason_;
    bool returns_ = false;  ///< whether the chosen solver takes over later
    int at_rest_ = 0;
    std::future<std::unique_ptr<PressureSolver>> coming_;
};

}  // namespace whorl
