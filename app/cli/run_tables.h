// The tables that `whorl run` writes: a row a step, and the median times.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/cli/columns.h"
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
    /// @throws std::runtime_error as Series
    Rows(const std::string& file, RowNames& names, Columns columns);
    void add(const Session& session);
    void finish() { series_.finish(); }

  private:
    RowNames& names_;
    Columns columns_;
    Series series_;
};

/// Medians over the steps of a run of the times that its phases took, and of what else has its row there,
/// lane by lane.
class Timings {
  public:
    explicit Timings(RowNames& names) : names_(names) {}
    void add(const Session& session);
    /// @throws std::runtime_error as Series
    void write(const std::string& file) const;

  private:
    struct Lane {
        std::string name;
        std::vector<std::vector<double>> values;  // of each column, step by step
    };

    RowNames& names_;
    Columns columns_{&Tables::timing, ""};
    std::map<int, Lane> lanes_;  // by Session::id
};

}  // namespace whorl::app
