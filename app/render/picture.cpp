// See picture.h.
#include "app/render/picture.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/render/arrows.h"
#include "app/render/colour_bar.h"
#include "app/render/framebuffer.h"
#include "app/render/gl_state.h"
#include "app/render/solids.h"
#include "app/render/theme.h"

namespace whorl::app {
namespace {

/// Text of this size is made for a picture this wide.
constexpr float reference_width = 900.0f;
constexpr float narrowest_points = 320.0f;
/// A tall domain is drawn narrower, so that the picture stays within this many times its width.
constexpr float tallest = 1.25f;
/// A row of cells is drawn this high.
constexpr float strip_points = 72.0f;
constexpr float margin_points = 24.0f;

/// Makes an ImGui context the current one for a scope.
class CurrentContext {
  public:
    explicit CurrentContext(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
        ImGui::SetCurrentContext(context);
    }
    ~CurrentContext() { ImGui::SetCurrentContext(before_); }
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;

  private:
    ImGuiContext* before_;
};

/// Puts the bound framebuffer back.
class FramebufferGuard {
  public:
    FramebufferGuard() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    }
    ~FramebufferGuard() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    }
    FramebufferGuard(const FramebufferGuard&) = delete;
    FramebufferGuard& operator=(const FramebufferGuard&) = delete;

  private:
    GLint draw_ = 0;
    GLint read_ = 0;
};

/// Where everything goes, pixels.
struct Layout {
    int width;
    int height;
    float left;        ///< of text and colour bar
    float text_width;  ///< of text and colour bar
    PixelRect field;
    float bar_y;
    float title_y;
    float caption_y;
};

/// Distance between the lines of a paragraph, as a part of the font's size.
constexpr float line_height = 1.4f;

/// Calls `line(begin, end)` for every line of the text, wrapped at `width` pixels.
template <class Line>
void for_each_line(const ImFont& font, const std::string& text, float width, Line&& line) {
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
        const char* const line_end = std::find(at, end, '\n');
        const char* stop = font.CalcWordWrapPositionA(1.0f, at, line_end, width);
        if (stop == at && stop < line_end) ++stop;  // not even a letter fits
        line(at, stop);
        at = stop;
        while (at < line_end && *at == ' ') ++at;
        if (at == line_end && at < end) ++at;
    }
}

float height_of(const ImFont& font, const std::string& text, float width) {
    float lines = 0.0f;
    for_each_line(font, text, width, [&](const char*, const char*) { lines += 1.0f; });
    return lines > 0.0f ? font.FontSize + (lines - 1.0f) * std::round(line_height * font.FontSize) : 0.0f;
}

Layout lay_out(const PictureRequest& request, glm::ivec2 cells, const Theme& theme, const ColourBar& bar) {
    const glm::vec2 domain(cells);
    const float aspect = domain.y / domain.x;
    auto wide = static_cast<float>(request.width);
    if (aspect > tallest) wide = wide * tallest / aspect;
    if (request.crisp && wide >= 2.0f * domain.x) wide = std::floor(wide / domain.x) * domain.x;
    wide = std::max(1.0f, std::round(wide));
    const float high = cells.y == 1 ? theme.px(strip_points) : std::max(1.0f, std::round(wide * aspect));

    Layout layout{};
    layout.text_width = std::max(wide, theme.px(narrowest_points));
    layout.left = theme.px(margin_points);
    layout.width = static_cast<int>(layout.text_width + 2.0f * layout.left);
    float y = layout.left;
    layout.title_y = y;
    if (!request.title.empty())
        y += height_of(*theme.title, request.title, layout.text_width) + theme.px(14.0f);
    layout.field = {static_cast<int>(layout.left + 0.5f * (layout.text_width - wide)), static_cast<int>(y),
                    static_cast<int>(wide), static_cast<int>(high)};
    y += high + theme.px(18.0f);
    layout.bar_y = y;
    y += colour_bar_height(theme, bar);
    if (!request.caption.empty()) {
        y += theme.px(16.0f);
        layout.caption_y = y;
        y += height_of(*theme.small, request.caption, layout.text_width);
    }
    layout.height = static_cast<int>(std::ceil(y + theme.px(margin_points - 4.0f)));
    return layout;
}

void add_paragraph(ImDrawList& list, const ImFont& font, ImVec2 at, float width, ImU32 colour,
                   const std::string& text) {
    for_each_line(font, text, width, [&](const char* begin, const char* end) {
        list.AddText(&font, font.FontSize, at, colour, begin, end);
        at.y += std::round(line_height * font.FontSize);
    });
}

glm::vec4 unpack(ImU32 colour) {
    const ImVec4 v = ImGui::ColorConvertU32ToFloat4(colour);
    return {v.x, v.y, v.z, v.w};
}

}  // namespace

struct PictureRenderer::Parts {
    ImGuiContext* imgui = nullptr;
    Theme theme;
    bool light = false;
    bool loaded = false;
    FieldView view;
    Arrows arrows;
    FieldTexture field;
    Solids solids;

    void load(float scale, bool wants_light) {
        if (loaded && theme.scale == scale && light == wants_light) return;
        if (loaded) ImGui_ImplOpenGL3_DestroyFontsTexture();
        theme = load_theme(scale, wants_light ? light_palette() : dark_palette());
        light = wants_light;
        loaded = true;
        ImGui_ImplOpenGL3_NewFrame();
        if (ImGui::GetIO().Fonts->TexID == nullptr) ImGui_ImplOpenGL3_CreateFontsTexture();
    }
};

PictureRenderer::PictureRenderer() : parts_(std::make_unique<Parts>()) {
    const CurrentContext restore(ImGui::GetCurrentContext());
    parts_->imgui = ImGui::CreateContext();
    ImGui::SetCurrentContext(parts_->imgui);
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().LogFilename = nullptr;
    if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
        ImGui::DestroyContext(parts_->imgui);
        throw std::runtime_error("ImGui finds no OpenGL 3.3 to draw pictures with");
    }
}

PictureRenderer::~PictureRenderer() {
    ImGuiContext* const before = ImGui::GetCurrentContext();
    ImGui::SetCurrentContext(parts_->imgui);
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(parts_->imgui);
    ImGui::SetCurrentContext(before);
}

Image PictureRenderer::render(const PictureRequest& request) {
    if (request.field.width() < 1 || request.field.height() < 1 || request.width < 1) {
        throw std::invalid_argument("a picture needs a field and a width");
    }
    const CurrentContext current(parts_->imgui);
    const GlStateGuard state;
    const FramebufferGuard bound;
    parts_->load(std::max(1.0f, static_cast<float>(request.width) / reference_width), request.light);
    const Theme& theme = parts_->theme;

    parts_->field.upload(request.field);
    FieldDraw draw;
    draw.cells = request.cells;
    draw.cells = domain_of(parts_->field, draw);
    parts_->solids.upload(request.solids, draw.cells.x, draw.cells.y);
    const ColourBar bar{request.map, request.lo, request.hi, request.label};
    const Layout layout = lay_out(request, draw.cells, theme, bar);
    const Framebuffer target(layout.width, layout.height);

    ImGui::GetIO().DisplaySize = {static_cast<float>(layout.width), static_cast<float>(layout.height)};
    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    add_paragraph(list, *theme.title, {layout.left, layout.title_y}, layout.text_width, theme.palette.text,
                  request.title);
    const ImVec2 low(static_cast<float>(layout.field.x), static_cast<float>(layout.field.y));
    const ImVec2 high(low.x + static_cast<float>(layout.field.width),
                      low.y + static_cast<float>(layout.field.height));
    list.AddRect({low.x - 1.0f, low.y - 1.0f}, {high.x + 1.0f, high.y + 1.0f}, theme.palette.border);
    draw_colour_bar(list, theme, bar, {layout.left, layout.bar_y}, layout.text_width);
    add_paragraph(list, *theme.small, {layout.left, layout.caption_y}, layout.text_width,
                  theme.palette.text_dim, request.caption);
    ImGui::Render();

    target.bind();
    const glm::vec4 background = unpack(theme.palette.background);
    glClearColor(background.r, background.g, background.b, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    draw.rect = layout.field;
    draw.framebuffer_height = layout.height;
    draw.scale = theme.scale;
    draw.lo = request.lo;
    draw.hi = request.hi;
    draw.crisp = request.crisp;
    parts_->view.draw(parts_->field, request.map, draw);
    parts_->solids.draw(request.map, draw);
    if (request.arrows != nullptr) parts_->arrows.draw(*request.arrows, draw, {.solids = request.solids});
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return target.read();
}

Image render_picture(const PictureRequest& request) {
    return PictureRenderer().render(request);
}

}  // namespace whorl::app
