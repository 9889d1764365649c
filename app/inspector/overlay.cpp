#include "app/inspector/overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/inspector/list.h"
#include "app/render/text.h"
#include "app/run/run_control.h"
#include "app/run/shared_state.h"
#include "app/ui/ui.h"

namespace whorl::app {
namespace {

constexpr ImU32 shadow = IM_COL32(0, 0, 0, 170);
constexpr double lines_from = 14;    // points of a cell from which its edges are drawn
constexpr double written_from = 34;  // points of a cell from which weights have room to be written
constexpr float cross_arm = 5;       // points: of the cross where the value is read

/// Whether a limiter has changed a sum's value.
bool cuts(const Sum& sum) {
    return sum.cut && sum.cut->changed();
}

/// One tile's overlay.
class Drawing {
  public:
    Drawing(const Theme& theme, const Inspection& inspection, const Grid& grid, const FieldViewports& place,
            const FieldTile& tile, ImDrawList& list)
        : theme_(theme),
          inspection_(inspection),
          place_(place),
          tile_(tile),
          list_(list),
          colours_(path_colours(theme_)),
          h_(grid.h),
          cell_(static_cast<float>(h_ * tile.rect.width / tile.width /
                                   static_cast<double>(place.window.high.x - place.window.low.x))) {}

    void draw(const Explanation& e) const {
        grid();
        outline(e);
        const std::size_t shown = inspection_.shown(e);
        const BaseStep& step = e.steps[shown];
        // The whole scheme's limiter looks at the first step's enclosing nodes.
        bounds(step, cuts(sum_of(e, shown)) || (shown == 0 && cuts(e.sum)));
        if (step.particles.empty()) {
            nodes(step);
        } else {
            particles(step);
        }
        path(step);
    }

    /// The cell under the pointer.
    void point_out(ImVec2 pointer) const {
        const WorldPoint p =
            place_.world(tile_, static_cast<double>(pointer.x), static_cast<double>(pointer.y));
        const WorldPoint middle{(std::floor(p.x / h_) + 0.5) * h_, (std::floor(p.y / h_) + 0.5) * h_};
        frame(at(middle), Site::Centre, faded(theme_.palette.text, 0.7f));
    }

  private:
    ImVec2 at(WorldPoint p) const {
        const glm::dvec2 pixel = place_.pixel(tile_, p);
        return {static_cast<float>(pixel.x), static_cast<float>(pixel.y)};
    }
    void line(ImVec2 a, ImVec2 b, ImU32 colour, float points) const {
        list_.AddLine(a, b, shadow, theme_.px(points) + 2 * theme_.thin());
        list_.AddLine(a, b, colour, theme_.px(points));
    }
    void dot(ImVec2 middle, float radius, ImU32 colour) const {
        list_.AddCircleFilled(middle, radius + theme_.thin(), shadow);
        list_.AddCircleFilled(middle, radius, colour);
    }

    /// The cells' edges, where cells are large.
    void grid() const {
        if (cell_ < theme_.px(static_cast<float>(lines_from))) return;
        const ImU32 colour = IM_COL32(255, 255, 255, 28);
        const WorldPoint low = place_.world(tile_, tile_.rect.x, tile_.rect.y + tile_.rect.height);
        const WorldPoint high = place_.world(tile_, tile_.rect.x + tile_.rect.width, tile_.rect.y);
        for (double x = std::ceil(low.x / h_); x * h_ <= high.x; ++x)
            list_.AddLine(at({x * h_, low.y}), at({x * h_, high.y}), colour, theme_.thin());
        for (double y = std::ceil(low.y / h_); y * h_ <= high.y; ++y)
            list_.AddLine(at({low.x, y * h_}), at({high.x, y * h_}), colour, theme_.thin());
    }
    /// The cell, or for a velocity the face, that is explained, and the one in a solid that was asked for.
    void outline(const Explanation& e) const {
        const Site site = e.quantity.info().site;
        const ImVec2 middle = at(e.at);
        frame(middle, site, colours_.scheme);
        if (!e.inside()) return;
        const WorldPoint asked{(e.i + offset_x(site)) * h_, (e.j + offset_y(site)) * h_};
        frame(at(asked), site, theme_.palette.text_dim);
        line(at(asked), middle, theme_.palette.text_dim, 1);
    }
    void frame(ImVec2 middle, Site site, ImU32 colour) const {
        const float half = 0.5f * cell_;
        const float x = site == Site::FaceX ? theme_.px(2) : half;
        const float y = site == Site::FaceY ? theme_.px(2) : half;
        const ImVec2 low{middle.x - x, middle.y - y}, high{middle.x + x, middle.y + y};
        const float width = theme_.px(2);
        list_.AddRect({low.x - width, low.y - width}, {high.x + width, high.y + width}, shadow, 0, 0, width);
        list_.AddRect(low, high, colour, 0, 0, width);
    }

    /// The square between the enclosing nodes; strong where a limiter has cut the value to their range.
    void bounds(const BaseStep& step, bool acted) const {
        const ImVec2 low = at(step.enclosing[0].at), high = at(step.enclosing[3].at);
        const ImU32 colour = acted ? theme_.palette.accent : faded(theme_.palette.text, 0.75f);
        const ImVec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
        for (int k = 0; k < 4; ++k) dashes(corners[k], corners[(k + 1) % 4], colour);
    }
    void dashes(ImVec2 from, ImVec2 to, ImU32 colour) const {
        const float length = std::hypot(to.x - from.x, to.y - from.y);
        const float dash = theme_.px(4);
        const auto along = [&](float far) {
            const float t = length > 0 ? far / length : 0;
            return ImVec2(from.x + t * (to.x - from.x), from.y + t * (to.y - from.y));
        };
        for (float x = 0; x < length; x += 2 * dash)
            list_.AddLine(along(x), along(std::min(x + dash, length)), colour, theme_.px(1));
    }

    void nodes(const BaseStep& step) const {
        for (std::size_t k = 0; k < step.nodes.size(); ++k) {
            const KernelNode& node = step.nodes[k];
            const bool pointed = inspection_.pointed && inspection_.pointed->term == k;
            const ImVec2 middle = at(node.at);
            const double weight = node.weight.value_or(0);
            if (!node.weight) {
                list_.AddCircle(middle, theme_.px(4), shadow, 0, theme_.px(3));
                list_.AddCircle(middle, theme_.px(4), theme_.palette.text, 0, theme_.px(1.5f));
                continue;
            }
            // The area is the weight; orange takes away.
            const float whole = std::min(0.42f * cell_, theme_.px(22));
            const float radius = std::max(
                theme_.px(2), whole * static_cast<float>(std::sqrt(std::min(1.0, std::abs(weight)))));
            dot(middle, radius, weight < 0 ? theme_.palette.accent : theme_.palette.text);
            if (pointed)
                list_.AddCircle(middle, radius + theme_.px(3), theme_.palette.accent, 0, theme_.px(2));
            write(step, middle, radius, weight);
        }
    }
    /// Below the node, or on another side of it where that leaves the path's ends free.
    void write(const BaseStep& step, ImVec2 middle, float radius, double weight) const {
        if (cell_ < theme_.px(static_cast<float>(written_from))) return;
        char text[16];
        std::snprintf(text, sizeof text, "%.2f", weight);
        const ImFont& font = *theme_.small;
        const float pad = theme_.px(2);
        const ImVec2 size{text_width(font, text) + 2 * pad, font.FontSize};
        const float off = radius + pad;
        const ImVec2 corners[] = {{middle.x - 0.5f * size.x, middle.y + off},
                                  {middle.x - 0.5f * size.x, middle.y - off - size.y},
                                  {middle.x + off, middle.y - 0.5f * size.y},
                                  {middle.x - off - size.x, middle.y - 0.5f * size.y}};
        const ImVec2* corner = std::ranges::find_if(corners, [&](ImVec2 c) {
            return !near(at(step.read), c, size) && !near(at(step.path.start), c, size);
        });
        if (corner == std::end(corners)) corner = corners;
        const ImVec2 low{std::floor(corner->x), std::floor(corner->y)};
        list_.AddRectFilled(low, {low.x + size.x, low.y + size.y}, shadow, pad);
        add_text(list_, font, {low.x + pad, low.y}, IM_COL32(255, 255, 255, 255), text);
    }
    /// Whether a cross at a place reaches into a rectangle.
    bool near(ImVec2 cross, ImVec2 low, ImVec2 size) const {
        const float reach = theme_.px(cross_arm + 2);
        return cross.x > low.x - reach && cross.x < low.x + size.x + reach && cross.y > low.y - reach &&
               cross.y < low.y + size.y + reach;
    }

    /// Where each began, a ring as large as its weight, and where the flow brought it from, a dot: both are
    /// seen where the flow is slow.
    void particles(const BaseStep& step) const {
        double most = 0;
        for (const StencilParticle& p : step.particles) most = std::max(most, p.weight);
        // Neighbours of a square of them do not touch.
        const float apart = cell_ / std::max(1.0f, std::sqrt(static_cast<float>(step.particles.size())) - 1);
        const float whole = std::min(0.4f * apart, theme_.px(7));
        for (std::size_t k = 0; k < step.particles.size(); ++k) {
            const StencilParticle& p = step.particles[k];
            const bool pointed = inspection_.pointed && inspection_.pointed->term == k;
            const ImVec2 start = at(p.path.start), end = at(p.path.end);
            list_.AddLine(start, end, faded(theme_.palette.text, 0.35f), theme_.thin());
            const float radius =
                std::max(theme_.px(1.5f), whole * static_cast<float>(std::sqrt(p.weight / most)));
            list_.AddCircle(start, radius, shadow, 0, theme_.px(1) + 2 * theme_.thin());
            list_.AddCircle(start, radius, theme_.palette.text, 0, theme_.px(1));
            dot(end, 0.5f * radius, colours_.scheme);
            if (!pointed) continue;
            line(start, end, theme_.palette.accent, 1.5f);
            list_.AddCircle(end, radius + theme_.px(3), theme_.palette.accent, 0, theme_.px(2));
            list_.AddCircle(start, radius + theme_.px(3), theme_.palette.accent, 0, theme_.px(2));
        }
    }

    /// From the node to where its value is read, an arrow of straight pieces, over the paths to compare with.
    void path(const BaseStep& step) const {
        dashed_path(step.euler, colours_.euler);
        dashed_path(step.midpoint, colours_.midpoint);
        for (std::size_t k = 1; k < step.fine.size(); ++k)
            list_.AddLine(at(step.fine[k - 1]), at(step.fine[k]), colours_.fine, theme_.thin());
        const ImVec2 start = at(step.path.start), end = at(step.path.end);
        line(start, end, colours_.scheme, 1.5f);
        arrow_head(start, end);
        dot(start, theme_.px(2.5f), colours_.scheme);
        const ImVec2 read = at(step.read);
        const float arm = theme_.px(cross_arm);
        line({read.x - arm, read.y}, {read.x + arm, read.y}, colours_.scheme, 1);
        line({read.x, read.y - arm}, {read.x, read.y + arm}, colours_.scheme, 1);
    }
    void dashed_path(const Path& path, ImU32 colour) const {
        dashes(at(path.start), at(path.end), colour);
        dot(at(path.end), theme_.px(2), colour);
    }
    void arrow_head(ImVec2 start, ImVec2 end) const {
        const float length = std::hypot(end.x - start.x, end.y - start.y);
        if (length < theme_.px(10)) return;
        const ImVec2 along{(end.x - start.x) / length, (end.y - start.y) / length};
        const float size = theme_.px(7);
        const ImVec2 back{end.x - size * along.x, end.y - size * along.y};
        const float half = 0.45f * size;
        list_.AddTriangleFilled(end, {back.x - half * along.y, back.y + half * along.x},
                                {back.x + half * along.y, back.y - half * along.x}, colours_.scheme);
    }

    const Theme& theme_;
    const Inspection& inspection_;
    const FieldViewports& place_;
    const FieldTile& tile_;
    ImDrawList& list_;
    PathColours colours_;
    double h_;
    float cell_;  ///< side, pixels
};

}  // namespace

PathColours path_colours(const Theme& theme) {
    const auto& series = theme.palette.series;
    return {series[1], series[4], series[2], theme.palette.text};
}

void InspectedOverlay::draw(const FieldViewports& fields, ImDrawList& list, bool) {
    if (!inspection_.open) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const FieldTile* under = fields.at(static_cast<double>(mouse.x), static_cast<double>(mouse.y));
    for (const FieldTile& tile : fields.tiles) {
        const Snapshot& lane = run_.session().lanes[tile.lane];
        const ImVec2 low{static_cast<float>(tile.part.x), static_cast<float>(tile.part.y)};
        const ImVec2 high{low.x + static_cast<float>(tile.part.width),
                          low.y + static_cast<float>(tile.part.height)};
        list.PushClipRect(low, high, true);
        const Drawing drawing(theme_, inspection_, lane.grid(), fields, tile, list);
        if (lane.explanation) drawing.draw(*lane.explanation);
        if (&tile == under) drawing.point_out(mouse);
        list.PopClipRect();
    }
}

std::vector<PlotMark> InspectedOverlay::marks() const {
    std::vector<PlotMark> marks;
    const auto& explanation = run_.snapshot().explanation;
    if (!inspection_.watched() || !explanation) return marks;
    const BaseStep& step = explanation->steps[inspection_.shown(*explanation)];
    const PathColours colours = path_colours(theme_);
    for (const KernelNode& node : step.nodes) {
        if (node.at.y < 0 || node.j != step.j) continue;
        const double weight = node.weight.value_or(0.25);
        marks.push_back({node.at.x, node.value, weight < 0 ? theme_.palette.accent : theme_.palette.text,
                         3 + 6 * static_cast<float>(std::sqrt(std::min(1.0, std::abs(weight)))), false});
    }
    for (const StencilParticle& particle : step.particles)
        marks.push_back({particle.path.end.x, particle.value, colours.scheme, 3});
    marks.push_back(
        {step.read.x, sum_of(*explanation, inspection_.shown(*explanation)).value(), colours.fine, 4});
    marks.push_back({explanation->at.x, explanation->now, colours.scheme, 6, false});
    return marks;
}

const OverlayEntry inspected_overlay{
    .key = "inspected", .make = [](const Services& s) -> std::unique_ptr<FieldOverlay> {
        return std::make_unique<InspectedOverlay>(s.ui.theme, s.run, s.shared.of<Inspection>());
    }};

}  // namespace whorl::app
