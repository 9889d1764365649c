// See picture.h.
#include "app/figure/picture.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/figure/sheet_layout.h"
#include "app/plot/colour_bar.h"
#include "app/plot/plot.h"
#include "app/render/arrows.h"
#include "app/render/framebuffer.h"
#include "app/render/gl_state.h"
#include "app/render/solids.h"
#include "app/render/text.h"
#include "app/render/theme.h"

namespace whorl::app {
namespace {

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

/// Pixels of a picture that are drawn at once, about: some milliseconds of a software rasteriser's.
constexpr int band_pixels = 400'000;

glm::vec4 unpack(ImU32 colour) {
    const ImVec4 v = ImGui::ColorConvertU32ToFloat4(colour);
    return {v.x, v.y, v.z, v.w};
}

void draw_head(ImDrawList& list, const Theme& theme, const SheetCell& cell, const SheetLayout::Head& head) {
    float indent = 0.0f;
    if (cell.colour >= 0) {
        const float side = swatch_side(theme);
        const float y = head.title.y + std::round(0.5f * (theme.bold->FontSize - side));
        list.AddRectFilled({head.title.x, y}, {head.title.x + side, y + side}, theme.lane(cell.colour),
                           theme.px(2.0f));
        indent = swatch_space(theme);
    }
    add_paragraph(list, *theme.bold, {head.title.x + indent, head.title.y}, head.width - indent,
                  theme.palette.text, cell.title);
    add_paragraph(list, *theme.small, {head.title.x, head.note_y}, head.width, theme.palette.text_dim,
                  cell.note);
}

/// Why a lane stopped, at the bottom of its field.
void draw_reason(ImDrawList& list, const Theme& theme, const std::string& reason, ImVec2 low, ImVec2 high) {
    const ImFont& small = *theme.small;
    const float pad = theme.px(7.0f);
    const float width = high.x - low.x - 2.0f * pad;
    const float top = std::max(low.y, high.y - paragraph_height(small, reason, width) - 2.0f * pad);
    list.PushClipRect(low, high, true);
    list.AddRectFilled({low.x, top}, high, faded(theme.palette.panel, 0.88f));
    list.AddRectFilled({low.x, top}, {high.x, top + theme.px(1.0f)}, theme.palette.accent);
    add_paragraph(list, small, {low.x + pad, top + pad}, width, theme.palette.text, reason);
    list.PopClipRect();
}

/// All of a cell but its field.
void draw_around(ImDrawList& list, const Theme& theme, const SheetLayout::Cell& place) {
    const SheetCell& cell = *place.cell;
    const ImVec2 low(static_cast<float>(place.field.x), static_cast<float>(place.field.y));
    const ImVec2 high(low.x + static_cast<float>(place.field.width),
                      low.y + static_cast<float>(place.field.height));
    if (place.head) draw_head(list, theme, cell, *place.head);
    if (cell.field == nullptr) list.AddRectFilled(low, high, theme.palette.card);
    // Its inner edge on the field's.
    const float out = 0.5f * (theme.thin() + 1.0f);
    list.AddRect({low.x - out, low.y - out}, {high.x + out, high.y + out}, theme.palette.border, 0.0f,
                 ImDrawFlags_None, theme.thin());
    if (!cell.stopped.empty()) draw_reason(list, theme, cell.stopped, low, high);
}

void draw_plot_of(ImDrawList& list, const Theme& theme, const SheetLayout::PlotPlace& place) {
    const SheetPlot& shown = *place.plot;
    std::vector<Series> series;
    for (const SheetCurve& curve : shown.curves) {
        const ImU32 colour = curve.colour < 0 ? theme.palette.text_dim : theme.lane(curve.colour);
        series.push_back({.label = curve.label, .colour = colour, .y = curve.y, .x = curve.x});
    }
    paint_plot(list, theme,
               {.title = shown.title,
                .unit = shown.unit,
                .x_name = shown.x_name,
                .x_unit = shown.x_unit,
                .log_x = shown.log_x,
                .log_y = shown.log_y,
                .size = place.size},
               series, place.corner);
}

/// All on the sheet but the fields, into the current ImGui context's draw data.
void draw_all_around(const Theme& theme, const SheetRequest& request, const SheetLayout& layout) {
    ImGui::GetIO().DisplaySize = {static_cast<float>(layout.width), static_cast<float>(layout.height)};
    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    add_paragraph(list, *theme.title, {layout.left, layout.title_y}, layout.text_width, theme.palette.text,
                  request.title);
    for (const SheetLayout::LabelLine& line : layout.labels) {
        add_text(list, *theme.body, line.at, line.first ? theme.palette.text : theme.palette.text_dim,
                 line.text);
    }
    for (const SheetLayout::Cell& place : layout.cells) draw_around(list, theme, place);
    draw_colour_bar(list, theme, {*request.map, request.lo, request.hi, request.label, request.below},
                    layout.bar, layout.bar_width);
    for (const SheetLayout::PlotPlace& place : layout.plots) draw_plot_of(list, theme, place);
    add_paragraph(list, *theme.small, {layout.left, layout.caption_y}, layout.text_width,
                  theme.palette.text_dim, request.caption);
    ImGui::Render();
}

Framebuffer band_of(const SheetLayout& layout) {
    check_drawable(layout.width, layout.height);
    return {layout.width, std::clamp(band_pixels / layout.width, 1, layout.height)};
}

/// A picture that has been begun. Its layout points into its request.
struct Work {
    Work(SheetRequest wanted, const Theme& theme)
        : request(std::move(wanted)),
          layout(lay_out(request, theme)),
          band(band_of(layout)),
          fields(layout.cells.size()),
          image{layout.width, layout.height, {}} {
        image.rgba.reserve(std::size_t{4} * layout.width * layout.height);
    }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    /// How a cell's field lies in the band that begins at a row.
    FieldDraw how(const Theme& theme, const SheetLayout::Cell& place, int row) const {
        FieldDraw draw;
        draw.rect = place.field;
        draw.rect.y -= row;
        draw.framebuffer_height = band.height();
        draw.scale = theme.scale;
        draw.lo = request.lo;
        draw.hi = request.hi;
        draw.crisp = request.crisp;
        draw.window = request.window;
        draw.cells = domain_of(*place.cell);
        return draw;
    }
    bool in_band(const SheetLayout::Cell& place) const {
        return place.cell->field != nullptr && place.field.y < rows + band.height() &&
               place.field.y + place.field.height > rows;
    }

    SheetRequest request;
    SheetLayout layout;
    Framebuffer band;
    std::vector<FieldTexture> fields;  ///< of the layout's cells, empty until they are drawn
    float fastest = 0.0f;              ///< one length of arrows for all fields
    int rows = 0;                      ///< that are done
    Image image;
};

}  // namespace

struct PictureRenderer::Parts {
    ImGuiContext* imgui = nullptr;
    Theme theme;
    bool light = false;
    bool loaded = false;
    FieldView view;
    Arrows arrows;
    Solids solids;
    std::optional<Work> work;

    void find_fastest() {
        for (const SheetLayout::Cell& place : work->layout.cells) {
            const SheetCell& cell = *place.cell;
            if (cell.field == nullptr || cell.arrows == nullptr) continue;
            work->fastest = std::max(work->fastest, arrows.fastest(*cell.arrows, work->how(theme, place, 0),
                                                                   {.solids = cell.solids}));
        }
    }

    void draw_fields() {
        for (std::size_t k = 0; k < work->layout.cells.size(); ++k) {
            const SheetLayout::Cell& place = work->layout.cells[k];
            if (!work->in_band(place)) continue;
            const SheetCell& cell = *place.cell;
            const FieldDraw draw = work->how(theme, place, work->rows);
            if (work->fields[k].empty()) work->fields[k].upload(*cell.field);
            solids.upload(cell.solids, draw.cells.x, draw.cells.y);
            view.draw(work->fields[k], *work->request.map, draw);
            solids.draw(*work->request.map, draw);
            if (cell.arrows == nullptr) continue;
            arrows.draw(*cell.arrows, draw, {.full_speed = work->fastest, .solids = cell.solids});
        }
    }

    /// ImGui's part of the band.
    void draw_around_fields() const {
        ImDrawData& data = *ImGui::GetDrawData();
        data.DisplayPos = {0.0f, static_cast<float>(work->rows)};
        data.DisplaySize.y = static_cast<float>(work->band.height());
        ImGui_ImplOpenGL3_RenderDrawData(&data);
    }

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

void PictureRenderer::begin(SheetRequest request) {
    check(request);
    const CurrentContext current(parts_->imgui);
    const GlStateGuard state;
    const FramebufferGuard bound;
    parts_->load(request.scale, request.light);
    parts_->work.emplace(std::move(request), parts_->theme);
    draw_all_around(parts_->theme, parts_->work->request, parts_->work->layout);
    parts_->find_fastest();
}

std::optional<Image> PictureRenderer::draw_band() {
    const CurrentContext current(parts_->imgui);
    const GlStateGuard state;
    const FramebufferGuard bound;
    Work& work = *parts_->work;
    work.band.bind();
    const glm::vec4 background = unpack(parts_->theme.palette.background);
    glClearColor(background.r, background.g, background.b, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    parts_->draw_fields();
    parts_->draw_around_fields();
    const Image band = work.band.read();
    const int rows = std::min(band.height, work.layout.height - work.rows);
    work.image.rgba.insert(work.image.rgba.end(), band.rgba.begin(),
                           band.rgba.begin() + std::ptrdiff_t{4} * rows * band.width);
    work.rows += rows;
    if (work.rows < work.layout.height) return std::nullopt;
    Image image = std::move(work.image);
    parts_->work.reset();
    return image;
}

Image PictureRenderer::render(SheetRequest request) {
    begin(std::move(request));
    for (;;) {
        if (std::optional<Image> image = draw_band()) return *std::move(image);
    }
}

Image render_picture(const SheetRequest& request) {
    return PictureRenderer().render(request);
}

}  // namespace whorl::app
