// Finds text that ImGui has drawn cut off or shortened, in what it hands to OpenGL.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

namespace whorl::app {

/// The letters of the last frame, from its triangles.
class DrawnText {
  public:
    /// Call after ImGui::Render.
    DrawnText() {
        for (const ImFont* font : ImGui::GetIO().Fonts->Fonts) {
            for (const ImFontGlyph& glyph : font->Glyphs) {
                if (glyph.Visible != 0) glyphs_.push_back(&glyph);
            }
        }
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int k = 0; k < data.CmdListsCount; ++k) read(*data.CmdLists[k]);
        end_line();
    }

    /// Lines that lose part of a letter at the left or right: a button clips its label so, and a window all
    /// that is in it.
    const std::vector<std::string>& cut() const { return cut_; }
    /// Lines that end in an ellipsis.
    const std::vector<std::string>& shortened() const { return shortened_; }
    /// All lines, a line break behind each.
    const std::string& all() const { return all_; }

  private:
    struct Box {
        ImVec2 low, high;
    };

    static constexpr float rounding =
        1e-5f;                             // of texture coordinates: less than 1/20 of a pixel of the atlas
    static constexpr float sliver = 0.6f;  // pixels of a letter that nobody misses: glyphs have soft edges
    static constexpr unsigned ellipsis = 0x2026;

    void read(const ImDrawList& list) {
        for (const ImDrawCmd& command : list.CmdBuffer) {
            for (unsigned k = 0; k + 6 <= command.ElemCount; ++k) {
                const ImDrawIdx* index = &list.IdxBuffer[static_cast<int>(command.IdxOffset + k)];
                // A letter is two triangles over four corners in a row, its upper left one first.
                const unsigned a = index[0];
                if (index[1] != a + 1 || index[2] != a + 2 || index[3] != a || index[4] != a + 2 ||
                    index[5] != a + 3)
                    continue;
                const ImDrawVert* corner = &list.VtxBuffer[static_cast<int>(command.VtxOffset + a)];
                take(corner[0], corner[2], command.ClipRect);
                k += 5;
            }
        }
        end_line();
    }

    void take(const ImDrawVert& low, const ImDrawVert& high, const ImVec4& clip) {
        const ImFontGlyph* glyph = glyph_at(low.uv, high.uv);
        if (glyph == nullptr) return;
        // Letters that go back or jump far begin another line.
        if (low.pos.x < x_ - 2 || low.pos.x > x_ + 40 || low.pos.y > bottom_ || high.pos.y < top_) end_line();
        if (line_.empty()) {
            top_ = low.pos.y;
            bottom_ = high.pos.y;
        }
        top_ = std::min(top_, low.pos.y);
        bottom_ = std::max(bottom_, high.pos.y);
        const float pixels = (high.pos.x - low.pos.x) / (high.uv.x - low.uv.x);
        const float letter = (glyph->U1 - glyph->U0) * pixels / (glyph->X1 - glyph->X0);  // of a unit
        const float begin = low.pos.x - glyph->X0 * letter;
        if (!line_.empty() && begin > x_ + 1) line_ += ' ';
        x_ = begin + glyph->AdvanceX * letter;
        append(glyph->Codepoint);
        // Scrolled out of sight above or below: nothing is lost. What hangs over to the left is not missed
        // either.
        if (high.pos.y <= clip.y || low.pos.y >= clip.w) return;
        const float lost = std::max({(low.uv.x - glyph->U0) * pixels, (glyph->U1 - high.uv.x) * pixels,
                                     clip.x - std::max(low.pos.x, begin), high.pos.x - clip.z});
        cuts_ = cuts_ || lost > sliver;
    }

    const ImFontGlyph* glyph_at(ImVec2 low, ImVec2 high) const {
        for (const ImFontGlyph* glyph : glyphs_) {
            if (low.x >= glyph->U0 - rounding && high.x <= glyph->U1 + rounding &&
                low.y >= glyph->V0 - rounding && high.y <= glyph->V1 + rounding && high.x > low.x)
                return glyph;
        }
        return nullptr;
    }

    void append(unsigned letter) {
        if (letter < 0x80) {
            line_ += static_cast<char>(letter);
        } else if (letter < 0x800) {
            line_ += static_cast<char>(0xc0 | (letter >> 6));
            line_ += static_cast<char>(0x80 | (letter & 0x3f));
        } else {
            line_ += static_cast<char>(0xe0 | (letter >> 12));
            line_ += static_cast<char>(0x80 | ((letter >> 6) & 0x3f));
            line_ += static_cast<char>(0x80 | (letter & 0x3f));
        }
        ends_in_ellipsis_ = letter == ellipsis;
    }

    void end_line() {
        if (cuts_) cut_.push_back(line_);
        if (ends_in_ellipsis_) shortened_.push_back(line_);
        if (!line_.empty()) all_ += line_ + '\n';
        line_.clear();
        cuts_ = ends_in_ellipsis_ = false;
    }

    std::vector<const ImFontGlyph*> glyphs_;
    std::vector<std::string> cut_, shortened_;
    std::string all_, line_;
    float x_ = 0, top_ = 0, bottom_ = 0;
    bool cuts_ = false, ends_in_ellipsis_ = false;
};

}  // namespace whorl::app
