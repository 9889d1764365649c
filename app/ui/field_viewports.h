// Where fields are on screen, for those who draw and paint on them.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "app/render/field_view.h"
#include "app/render/view_window.h"
#include "core/scene/state.h"

namespace whorl::app {

/// The field of one lane.
struct FieldTile {
    std::size_t lane = 0;
    PixelRect rect;                ///< of the whole field
    PixelRect part;                ///< of it, where this lane is seen
    double width = 0, height = 0;  ///< of the lane's domain, length

    bool contains(double x, double y) const {
        return x >= part.x && y >= part.y && x < part.x + part.width && y < part.y + part.height;
    }
};

struct FieldViewports {
    std::vector<FieldTile> tiles;  ///< none if the run is drawn as curves
    ViewWindow window{};           ///< part of the domain that each shows
    glm::ivec2 cells{1, 1};        ///< of the finest lane
    std::optional<float> wipe{};   ///< x of the line that divides two lanes
    bool covered = false;          ///< a list or the help lies over them: do not paint

    /// The tile under a pixel, if any.
    const FieldTile* at(double x, double y) const {
        if (covered) return nullptr;
        for (const FieldTile& tile : tiles) {
            if (tile.contains(x, y)) return &tile;
        }
        return nullptr;
    }
    /// A lane's tile, if it is on screen.
    const FieldTile* of(std::size_t lane) const {
        for (const FieldTile& tile : tiles) {
            if (tile.lane == lane) return &tile;
        }
        return nullptr;
    }
    /// A pixel's place in the window, as fractions of its sides from the lower left corner.
    static glm::dvec2 part(const FieldTile& tile, double x, double y) {
        return {(x - tile.rect.x) / tile.rect.width, 1 - (y - tile.rect.y) / tile.rect.height};
    }
    /// What is shown instead of `shown` after a turn of the wheel over a pixel, which stays where it is; the
    /// middle does where the pixel is on no field.
    ViewWindow zoomed_about(const ViewWindow& shown, double x, double y, double notches) const;
    /// The point under a pixel.
    WorldPoint world(const FieldTile& tile, double x, double y) const {
        const glm::dvec2 low(window.low);
        const glm::dvec2 at = low + part(tile, x, y) * (glm::dvec2(window.high) - low);
        return {at.x * tile.width, at.y * tile.height};
    }
    /// The pixel of a point.
    glm::dvec2 pixel(const FieldTile& tile, WorldPoint at) const {
        const glm::dvec2 low(window.low);
        const glm::dvec2 in =
            (glm::dvec2(at.x / tile.width, at.y / tile.height) - low) / (glm::dvec2(window.high) - low);
        return {tile.rect.x + in.x * tile.rect.width, tile.rect.y + (1 - in.y) * tile.rect.height};
    }
};

}  // namespace whorl::app
