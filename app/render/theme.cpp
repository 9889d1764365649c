// See theme.h.
#include "app/render/theme.h"

#include <imgui_freetype.h>
#include <cmath>

#include <filesystem>

namespace whorl::app {
namespace {

constexpr const char* inter = "/usr/share/fonts/opentype/inter/Inter-Regular.otf";
constexpr const char* inter_semi_bold = "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf";
constexpr const char* jetbrains_mono = "/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf";
constexpr const char* dejavu = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* dejavu_bold = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";

/// Latin, Greek, typography, superscripts, arrows, operators and the few marks that panels use. ImGui keeps
/// the pointer.
constexpr ImWchar glyphs[] = {
    0x0020, 0x00ff, 0x0131, 0x0131, 0x02c6, 0x02dc, 0x0370, 0x03ff, 0x1d2c, 0x1d6a, 0x2010, 0x2027,
    0x2032, 0x2033, 0x2070, 0x209c, 0x2113, 0x2113, 0x2190, 0x2195, 0x21b5, 0x21bb, 0x2202, 0x2202,
    0x2206, 0x220f, 0x2211, 0x221e, 0x222b, 0x222b, 0x2248, 0x2248, 0x2260, 0x2265, 0x22c5, 0x22c5,
    0x25a0, 0x25a1, 0x25b2, 0x25bd, 0x25cb, 0x25cf, 0x2713, 0x2717, 0,
};

bool exists(const char* path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

ImFont* add_font(const char* path, const char* symbols, float pixels) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.OversampleH = 1;
    config.PixelSnapH = true;
    config.SizePixels = pixels;
    ImFont* font = exists(path) ? atlas.AddFontFromFileTTF(path, pixels, &config, glyphs)
                                : atlas.AddFontDefault(&config);
    if (exists(symbols)) {
        config.MergeMode = true;
        atlas.AddFontFromFileTTF(symbols, pixels, &config, glyphs);
    }
    return font;
}

void set_colours(ImGuiStyle& style, const Palette& palette) {
    const auto set = [&](ImGuiCol slot, ImU32 colour) {
        style.Colors[slot] = ImGui::ColorConvertU32ToFloat4(colour);
    };
    const ImU32 frame_hovered = IM_COL32(43, 48, 58, 255);
    const ImU32 frame_active = IM_COL32(52, 58, 70, 255);
    set(ImGuiCol_Text, palette.text);
    set(ImGuiCol_TextDisabled, palette.text_dim);
    set(ImGuiCol_TextSelectedBg, faded(palette.accent, 0.35f));
    set(ImGuiCol_WindowBg, palette.panel);
    set(ImGuiCol_ChildBg, 0);
    set(ImGuiCol_PopupBg, palette.panel);
    set(ImGuiCol_Border, palette.border);
    set(ImGuiCol_FrameBg, palette.frame);
    set(ImGuiCol_FrameBgHovered, frame_hovered);
    set(ImGuiCol_FrameBgActive, frame_active);
    set(ImGuiCol_TitleBg, palette.panel);
    set(ImGuiCol_TitleBgActive, palette.panel);
    set(ImGuiCol_TitleBgCollapsed, palette.panel);
    set(ImGuiCol_MenuBarBg, palette.panel);
    set(ImGuiCol_ScrollbarBg, 0);
    set(ImGuiCol_ScrollbarGrab, palette.border);
    set(ImGuiCol_ScrollbarGrabHovered, frame_active);
    set(ImGuiCol_ScrollbarGrabActive, palette.accent);
    set(ImGuiCol_CheckMark, palette.accent);
    set(ImGuiCol_SliderGrab, palette.accent);
    set(ImGuiCol_SliderGrabActive, palette.accent);
    set(ImGuiCol_Button, IM_COL32(43, 48, 58, 255));
    set(ImGuiCol_ButtonHovered, IM_COL32(57, 63, 76, 255));
    set(ImGuiCol_ButtonActive, IM_COL32(70, 77, 92, 255));
    set(ImGuiCol_Header, palette.frame);
    set(ImGuiCol_HeaderHovered, frame_hovered);
    set(ImGuiCol_HeaderActive, frame_active);
    set(ImGuiCol_Separator, palette.border);
    set(ImGuiCol_SeparatorHovered, palette.accent);
    set(ImGuiCol_SeparatorActive, palette.accent);
    set(ImGuiCol_ResizeGrip, 0);
    set(ImGuiCol_ResizeGripHovered, palette.border);
    set(ImGuiCol_ResizeGripActive, palette.accent);
    set(ImGuiCol_Tab, palette.panel);
    set(ImGuiCol_TabHovered, frame_hovered);
    set(ImGuiCol_TabActive, palette.frame);
    set(ImGuiCol_TableHeaderBg, palette.frame);
    set(ImGuiCol_TableBorderStrong, palette.border);
    set(ImGuiCol_TableBorderLight, palette.border);
    set(ImGuiCol_TableRowBg, 0);
    set(ImGuiCol_TableRowBgAlt, IM_COL32(255, 255, 255, 6));
    set(ImGuiCol_DragDropTarget, palette.accent);
    set(ImGuiCol_NavHighlight, palette.accent);
    set(ImGuiCol_ModalWindowDimBg, IM_COL32(0, 0, 0, 140));
}

}  // namespace

Palette dark_palette() {
    return {
        .background = IM_COL32(13, 15, 19, 255),
        .panel = IM_COL32(18, 21, 27, 255),
        .card = IM_COL32(29, 32, 39, 255),
        .frame = IM_COL32(32, 36, 44, 255),
        .border = IM_COL32(48, 53, 63, 255),
        .grid = IM_COL32(45, 50, 59, 255),
        .text = IM_COL32(231, 233, 237, 255),
        .text_dim = IM_COL32(150, 156, 168, 255),
        .accent = IM_COL32(255, 138, 92, 255),
        .accent_text = IM_COL32(24, 16, 12, 255),
        .hairline = IM_COL32(200, 206, 218, 130),
        .series = {IM_COL32(255, 138, 92, 255), IM_COL32(70, 185, 243, 255), IM_COL32(121, 251, 187, 255),
                   IM_COL32(134, 118, 254, 255), IM_COL32(255, 211, 46, 255), IM_COL32(179, 115, 148, 255)},
    };
}

Palette light_palette() {
    return {
        .background = IM_COL32(255, 255, 255, 255),
        .panel = IM_COL32(255, 255, 255, 255),
        .card = IM_COL32(247, 248, 250, 255),
        .frame = IM_COL32(236, 238, 241, 255),
        .border = IM_COL32(176, 181, 190, 255),
        .grid = IM_COL32(226, 229, 234, 255),
        .text = IM_COL32(22, 25, 31, 255),
        .text_dim = IM_COL32(88, 94, 105, 255),
        .accent = IM_COL32(205, 84, 36, 255),
        .accent_text = IM_COL32(255, 255, 255, 255),
        .hairline = IM_COL32(60, 66, 78, 130),
        .series = {IM_COL32(205, 84, 36, 255), IM_COL32(12, 98, 131, 255), IM_COL32(68, 138, 103, 255),
                   IM_COL32(151, 120, 176, 255), IM_COL32(106, 77, 1, 255), IM_COL32(111, 17, 55, 255)},
    };
}

ImU32 faded(ImU32 colour, float alpha) {
    const auto old = static_cast<float>((colour >> IM_COL32_A_SHIFT) & 0xff);
    return (colour & ~IM_COL32_A_MASK) | (static_cast<ImU32>(std::lround(old * alpha)) << IM_COL32_A_SHIFT);
}

Theme load_theme(float content_scale, const Palette& palette) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    io.Fonts->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    io.Fonts->TexGlyphPadding = 2;

    Theme theme;
    theme.scale = content_scale;
    theme.palette = palette;
    theme.body = add_font(inter, dejavu, theme.px(14.0f));
    theme.bold = add_font(inter_semi_bold, dejavu_bold, theme.px(14.0f));
    theme.title = add_font(inter_semi_bold, dejavu_bold, theme.px(17.0f));
    theme.small = add_font(inter, dejavu, theme.px(12.0f));
    theme.mono = add_font(jetbrains_mono, dejavu, theme.px(12.5f));
    io.FontDefault = theme.body;
    io.Fonts->Build();

    ImGuiStyle style;
    style.WindowPadding = {14, 14};
    style.WindowRounding = 7;
    style.WindowBorderSize = 1;
    style.ChildRounding = 7;
    style.PopupRounding = 7;
    style.PopupBorderSize = 1;
    style.FramePadding = {9, 5};
    style.FrameRounding = 4;
    style.FrameBorderSize = 0;
    style.ItemSpacing = {8, 7};
    style.ItemInnerSpacing = {8, 5};
    style.GrabMinSize = 11;
    style.GrabRounding = 3;
    style.ScrollbarSize = 11;
    style.ScrollbarRounding = 6;
    style.TabRounding = 4;
    style.IndentSpacing = 16;
    style.WindowTitleAlign = {0.0f, 0.5f};
    style.WindowMenuButtonPosition = ImGuiDir_None;
    set_colours(style, palette);
    style.ScaleAllSizes(content_scale);
    ImGui::GetStyle() = style;
    return theme;
}

}  // namespace whorl::app
