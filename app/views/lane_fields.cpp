#include "app/views/lane_fields.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace whorl::app {
namespace {

/// Whether two grids cover the same domain: their rows are rounded to whole cells.
bool same_domain(const Grid& a, const Grid& b) {
    const double rounding = 0.5 * std::max(a.h, b.h);
    return std::abs(a.width() - b.width()) <= rounding && std::abs(a.height() - b.height()) <= 2 * rounding;
}

}  // namespace

void LaneFields::update(const SessionSnapshot& session, const View& view, bool difference) {
    if (serial_ == session.serial && view_ == &view && difference_ == difference) return;
    serial_ = session.serial;
    view_ = &view;
    difference_ = difference;
    reference_ = static_cast<std::size_t>(std::max(0, session.setup.reference));
    const std::size_t lanes = session.lanes.size();
    worked_out_.resize(lanes);
    fields_.resize(lanes);
    for (std::size_t k = 0; k < lanes; ++k) fields_[k] = view.field(session.lanes[k], worked_out_[k]);
    if (difference) subtract(session);
    measure_span(session);
    ++version_;
}

/// The reference's field on the lane's grid; null if it has none for the lane's domain.
const Field* LaneFields::reference_on(const Snapshot& reference, const Snapshot& lane) {
    const Field* field = fields_[reference_];
    if (field == nullptr || !same_domain(reference.grid(), lane.grid())) return nullptr;
    if (reference.grid() == lane.grid()) return field;
    const Boundary& boundary = reference.state.boundary;
    filled_ = *field;
    boundary.fill(filled_);
    const Field& shape = lane.density();
    if (!averaged_.same_shape(shape)) averaged_ = shape;
    averager_.average(filled_, boundary, lane.grid(), averaged_);
    return &averaged_;
}

void LaneFields::subtract(const SessionSnapshot& session) {
    differences_.resize(fields_.size());
    shown_.assign(fields_.size(), false);
    for (std::size_t k = 0; k < fields_.size(); ++k) {
        const Field* minuend = fields_[k];
        const Field* subtrahend = reference_on(session.lanes[reference_], session.lanes[k]);
        if (minuend == nullptr || subtrahend == nullptr) continue;
        Field& out = differences_[k];
        if (!out.same_shape(*minuend)) out = *minuend;
        for (int j = 0; j < out.height(); ++j) {
            const Real* of_lane = minuend->row(j);
            std::transform(of_lane, of_lane + out.width(), subtrahend->row(j), out.row(j),
                           std::minus<Real>());
        }
        shown_[k] = true;
    }
    for (std::size_t k = 0; k < fields_.size(); ++k) fields_[k] = shown_[k] ? &differences_[k] : nullptr;
}

void LaneFields::measure_span(const SessionSnapshot& session) {
    const View& measured = difference_ ? app::view("difference") : *view_;
    const float centre = measured.centre(session.lanes.front());
    Range span{centre, centre};
    least_ = 0;
    for (std::size_t k = 0; k < fields_.size(); ++k) {
        if (fields_[k] == nullptr) continue;
        const Range extent = measured.extent(session.lanes[k], *fields_[k]);
        if (!measured.diverges()) least_ = std::min(least_, extent.lo);
        const Range shown = measured.shown(session.lanes[k], extent);
        span = {std::min(span.lo, shown.lo), std::max(span.hi, shown.hi)};
    }
    if (span.lo == span.hi) span = {measured.diverges() ? centre - 1 : 0, centre + 1};
    span_ = span;
}

std::string shown_quantity(const LaneFields& fields, const LaneNames& names) {
    std::string words(fields.view().label);
    if (fields.difference()) words += " less that of " + names.name(fields.reference());
    return words;
}

}  // namespace whorl::app
