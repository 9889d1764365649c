// The tables that `whorl run` writes: a row a step, and the median times.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/io/series.h"
#include "core/session/session.h"

namespace whorl::app {

/// What lanes are called in tables: each as when it came, wherever it moves and whatever it is set to later.
class RowNames {
  public:
    explicit RowNames(const Recording& recording);
    /// Whether the run has several lanes at any time, so that tables name them.
    bool several() const { return several_; }
    const std::string& of(const Session& session, std::size_t k);

  private:
    std::string unused(const std::string& title) const;

    bool several_;
    std::map<int, std::string> names_;  // by Session::id
};

/// A row a step, or with several lanes a row a step and lane.
class Rows {
  public:
    /// @param file  or `-` for standard output
    /// @param limited  adds the numbers of nodes that limiters changed
    /// @throws std::runtime_error as Series
    Rows(const std::string& file, RowNames& names, bool limited);
    void add(const Session& session);
    void finish() { series_.finish(); }

  private:
    RowNames& names_;
    bool limited_;
    Series series_;
};

/// Median times over the steps of a run, ms, phase by phase, lane by lane.
class Timings {
  public:
    explicit Timings(RowNames& names) : names_(names) {}
    void add(const Session& session);
    /// @throws std::runtime_error as Series
    void write(const std::string& file) const;

  private:
    struct Step {
        PhaseTimes ms;
        SolveReport pressure;
    };
    struct Lane {
        std::string name;
        std::vector<Step> steps;
    };

    RowNames& names_;
    std::map<int, Lane> lanes_;  // by Session::id
};

}  // namespace whorl::app
