// The columns of a table of measures.
#pragma once

#include <string>
#include <vector>

#include "core/measure/measure.h"

namespace whorl::app {

/// The measures that a table has after step and time.
class Columns {
  public:
    /// @param picked  keys as "a,b"; empty: those that the table has of itself
    /// @param also    and those with this need
    /// @throws InputError that names the nearest keys
    Columns(bool Tables::*table, const std::string& picked, Needs also = Needs::Nothing);

    /// Errors before all others, as `whorl experiment` has them.
    void errors_first();
    const std::vector<const Measure*>& all() const { return measures_; }

    /// `step,time,…`
    std::string header() const;
    /// Of one lane at one step. The reference holds until the next call.
    const std::vector<double>& row(long step, const Measures& measured);

  private:
    void add(const Measure& measure);

    std::vector<const Measure*> measures_;
    std::vector<double> row_;
};

}  // namespace whorl::app
