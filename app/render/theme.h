// How everything looks: colours, fonts and ImGui's style.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace whorl::app {

/// The colours that drawing code takes by role.
struct Palette {
    ImU32 background;  ///< behind everything
    ImU32 panel;       ///< a column of controls
    ImU32 card;        ///< a plot on a panel
    ImU32 frame;       ///< a control
    ImU32 border;      ///< one pixel around panels, cards and pictures
    ImU32 grid;        ///< lines behind a plot
    ImU32 text;
    ImU32 text_dim;     ///< captions, axes, units
    ImU32 accent;       ///< what is active; used sparingly
    ImU32 accent_text;  ///< on the accent
    ImU32 hairline;     ///< under the pointer
    /// Curves and lanes, in order: far apart for normal and for colour-blind eyes, legible on a card.
    std::array<ImU32, 6> series;
};

Palette dark_palette();
/// For pictures that go on paper.
Palette light_palette();

/// Fonts of the current ImGui context, and its palette. A value: copy it freely, it dies with the context's
/// fonts.
struct Theme {
    float scale = 1.0f;       ///< framebuffer pixels to a point
    ImFont* body = nullptr;   ///< 14 points
    ImFont* bold = nullptr;   ///< 14 points, section headings
    ImFont* title = nullptr;  ///< 17 points
    ImFont* small = nullptr;  ///< 12 points, captions and axes
    ImFont* mono = nullptr;   ///< 12.5 points, figures that change
    Palette palette;

    /// Colour of the lane with index k >= 0, the same hue on dark and on light.
    ImU32 lane(int k) const { return palette.series[static_cast<std::size_t>(k) % palette.series.size()]; }
    /// Points to framebuffer pixels, whole ones.
    float px(float points) const { return std::round(points * scale); }
    /// Width of a thin line, framebuffer pixels.
    float thin() const { return std::max(1.0f, px(1.0f)); }
};

/// Replaces the fonts and the style of the current ImGui context. A font file that is not installed is
/// replaced by ImGui's own. Call between frames. To change the scale of a window that has drawn already, call
/// ImGui_ImplOpenGL3_DestroyFontsTexture before and ImGui_ImplOpenGL3_CreateFontsTexture after.
Theme load_theme(float content_scale, const Palette& palette = dark_palette());

/// Colour with its alpha multiplied by `alpha` in [0, 1].
ImU32 faded(ImU32 colour, float alpha);

}  // namespace whorl::app
