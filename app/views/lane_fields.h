// What a view shows of every lane, or how each differs from the reference lane.
#pragma once

#include <vector>

#include "app/render/colour_map.h"
#include "app/views/lane_names.h"
#include "app/views/views.h"
#include "core/measure/average.h"

namespace whorl::app {

/// The fields of one view, worked out once for a snapshot. Allocates only when lanes, view or grids change.
class LaneFields {
  public:
    /// @param session     must live as long as the fields are read
    /// @param difference  each lane less the reference lane, which is averaged to the lane's grid
    void update(const SessionSnapshot& session, const View& view, bool difference);

    const View& view() const { return *view_; }
    bool difference() const { return difference_; }
    /// The lane that others are compared with: the session's reference, or else the first.
    std::size_t reference() const { return reference_; }
    /// Null where the lane has no such field, or the reference lane covers another domain.
    const Field* of(std::size_t lane) const { return fields_[lane]; }
    /// What all lanes span, in fluid cells: the view's own range, or one symmetric about 0 for differences.
    Range span() const { return span_; }
    /// Whether a lane has values so far below these ends of the colours that they show.
    bool below(Range ends) const { return least_ < ends.lo - least_depth * (ends.hi - ends.lo); }
    /// Grows with every change.
    long version() const { return version_; }

  private:
    void subtract(const SessionSnapshot& session);
    const Field* reference_on(const Snapshot& reference, const Snapshot& lane);
    void measure_span(const SessionSnapshot& session);

    std::uint64_t serial_ = ~std::uint64_t{0};
    const View* view_ = nullptr;
    bool difference_ = false;
    std::size_t reference_ = 0;
    std::vector<const Field*> fields_;
    std::vector<Field> worked_out_;  ///< of views that no snapshot holds
    std::vector<Field> differences_;
    std::vector<char> shown_;  ///< whether a lane has a difference
    Field filled_, averaged_;  ///< the reference, with its ghosts; on a lane's grid
    Averager averager_;
    Range span_{0, 1};
    float least_ = 0;  ///< value of a view without a middle
    long version_ = 0;
};

/// What the colours or curves stand for: the view, and what is taken from it.
std::string shown_quantity(const LaneFields& fields, const LaneNames& names);

}  // namespace whorl::app
