// Pictures of a session: all lanes at one step, or a contact sheet with a row a step and a column a lane.
#pragma once

#include "app/views/views.h"

namespace whorl::app {

/// The range that shows all lanes of all snapshots.
/// @throws InputError if the view has no field in one of them
Range range_of(std::span<const SessionSnapshot> rows, const View& view);

/// Draws the lanes of one snapshot side by side, or of several in rows, with one range and one colour bar.
/// @param rows  of the same lanes; at least one
/// @throws as picture_of, InputError also if the picture is larger than the driver draws
Image picture_of(std::span<const SessionSnapshot> rows, const PictureStyle& style, PictureRenderer& renderer);

}  // namespace whorl::app
