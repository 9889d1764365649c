// Figures 4.2 and 4.3 of the thesis, alive: a node's particles and their weights.

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/labs/canvas.h"
#include "app/labs/list.h"
#include "app/labs/weight_profile.h"
#include "app/ui/ui.h"
#include "core/stencils/stencil.h"

namespace whorl::app {
namespace {

struct StencilChoice {
    Id<StencilShape> kind;
    Id<WeightKernel> weights;
    int zeta = 2;
    int dimensions = 2;
    int seed = 1;
    bool operator==(const StencilChoice&) const = default;
};

/// How large a particle's dot is where it counts the most, points; its area goes with its weight.
constexpr float largest_dot = 8;

double distance(const Particle& particle) {
    return std::hypot(static_cast<double>(particle.offset.x), static_cast<double>(particle.offset.y));
}

/// What is said of all particles together.
struct Summary {
    double sum = 0, least = 1, most = 0;
    explicit Summary(std::span<const Particle> particles) {
        for (const Particle& particle : particles) {
            const auto weight = static_cast<double>(particle.weight);
            sum += weight;
            least = std::min(least, weight);
            most = std::max(most, weight);
        }
    }
};

/// The cells around the node, its own one marked, and the circle of radius Δ_r around it.
void draw_grid(const Theme& theme, const Canvas& canvas, int dimensions) {
    ImDrawList& list = canvas.begin();
    const double half = dimensions == 1 ? 0.12 : 0.5;
    list.AddRectFilled(canvas.pixel(-0.5, half), canvas.pixel(0.5, -half), faded(theme.palette.text, 0.05f));
    list.AddRect(canvas.pixel(-0.5, half), canvas.pixel(0.5, -half), theme.palette.border, 0, 0,
                 theme.px(1.5f));
    const int across = dimensions == 1 ? 0 : 1;
    for (int j = -across; j <= across; ++j) {
        for (int i = -1; i <= 1; ++i) {
            const ImVec2 at = canvas.pixel(i, j);
            const float arm = theme.px(6);
            list.AddLine({at.x - arm, at.y}, {at.x + arm, at.y}, theme.palette.text_dim, theme.px(2));
            list.AddLine({at.x, at.y - arm}, {at.x, at.y + arm}, theme.palette.text_dim, theme.px(2));
        }
    }
    canvas.end();
    if (dimensions == 1) return;
    std::vector<ImVec2> circle;
    for (int k = 0; k <= 96; ++k) {
        const double angle = 2 * std::numbers::pi * k / 96;
        const double radius = Stencil::radius(dimensions);
        circle.push_back(canvas.pixel(radius * std::cos(angle), radius * std::sin(angle)));
    }
    canvas.dashes(circle, faded(theme.palette.text_dim, 0.6f));
}

/// The neighbours' particles, as rings: where one lies around a dot, two nodes share it.
void draw_neighbours(const Theme& theme, const Canvas& canvas, const Stencil& stencil, int dimensions) {
    const int across = dimensions == 1 ? 0 : 1;
    const float radius = theme.px(largest_dot + 1.5f);
    for (int j = -across; j <= across; ++j) {
        for (int i = -1; i <= 1; ++i) {
            if (i == 0 && j == 0) continue;
            for (const Particle& particle : stencil.particles()) {
                const double x = i + static_cast<double>(particle.offset.x);
                const double y = j + static_cast<double>(particle.offset.y);
                const ImVec2 at = canvas.pixel(x, y);
                const Frame& f = canvas.frame();
                const bool whole = at.x - radius >= f.low.x && at.x + radius <= f.high.x &&
                                   at.y - radius >= f.low.y && at.y + radius <= f.high.y;
                if (whole) canvas.ring(x, y, radius, faded(theme.palette.text_dim, 0.35f));
            }
        }
    }
}

std::string describe(const Particle& particle, int dimensions) {
    const auto x = static_cast<double>(particle.offset.x), y = static_cast<double>(particle.offset.y);
    char line[160];
    std::snprintf(line, sizeof line, "Offset (%.3f, %.3f) cells\nDistance %.3f cells = %.3f Δ_r\nWeight %.5f",
                  x, y, distance(particle), distance(particle) / Stencil::radius(dimensions),
                  static_cast<double>(particle.weight));
    return line;
}

void numbers(const Theme& theme, std::span<const Particle> particles) {
    const Summary summary(particles);
    char line[160];
    std::snprintf(line, sizeof line, "%zu particle%s  ·  weights sum to %.6f", particles.size(),
                  particles.size() == 1 ? "" : "s", summary.sum);
    ImGui::TextUnformatted(line);
    std::snprintf(line, sizeof line, "least %.5f  ·  most %.5f  ·  ratio %.3f", summary.least, summary.most,
                  summary.least / summary.most);
    text(theme.palette.text_dim, line);
}

class StencilLab final : public Lab {
  public:
    explicit StencilLab(Ui& ui) : ui_(ui) {}

    void draw() override {
        controls(choice_);
        if (!stencil_ || !(made_ == choice_)) {
            const StencilChoice& c = choice_;
            stencil_.emplace(c.kind, c.zeta, c.weights, c.dimensions, static_cast<std::uint64_t>(c.seed));
            made_ = choice_;
        }
        const Theme& theme = ui_.theme;
        const float lines = 2 * ImGui::GetTextLineHeightWithSpacing() + theme.px(2);
        const ImVec2 room = ImGui::GetContentRegionAvail();
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        const float height = std::max(room.y - lines, theme.px(150));
        const float left = std::floor(0.55f * (room.x - gap));
        particles_plot({left, height});
        ImGui::SameLine(0, gap);
        weights_plot({room.x - left - gap, height});
        numbers(theme, stencil_->particles());
    }

  private:
    /// A row of chips, one for each scheme of a list.
    template <class Entry>
    void scheme_chips(const char* key, Id<Entry>& chosen) {
        const std::size_t count = Entry::list().all().size();
        const float width = chip_width(static_cast<int>(count));
        for (std::size_t k = 0; k < count; ++k) {
            const SchemeInfo& info = Id<Entry>::at(k).info();
            if (ui_.chip_in_row(std::string(key) + std::string(info.key), chosen.index() == k, width, k == 0,
                                {info.label, info.help, "", info.source, ""}))
                chosen = Id<Entry>::at(k);
        }
    }

    void controls(StencilChoice& choice) {
        const Theme& theme = ui_.theme;
        scheme_chips("stencil-kind=", choice.kind);
        scheme_chips("stencil-weights=", choice.weights);
        const float width = chip_width(3);
        for (const int dimensions : {1, 2}) {
            const std::string key = "stencil-dimensions=" + std::to_string(dimensions);
            if (ui_.chip_in_row(
                    key, choice.dimensions == dimensions, std::floor(0.5f * width), dimensions == 1,
                    {dimensions == 1 ? "1D" : "2D", "Particles on a line, or in the plane; Δ_r = ½√d cells.",
                     "", "thesis sec. 4.1", ""}))
                choice.dimensions = dimensions;
        }
        const bool jittered = choice.kind->traits.seeded;
        const auto whole = [&](const char* label, const char* id, int& value, int least, int most, float wide,
                               const TooltipText& help) {
            ImGui::SameLine();
            ImGui::AlignTextToFramePadding();
            text(theme.palette.text_dim, label);
            ImGui::SameLine();
            ImGui::SetNextItemWidth(wide);
            ui_.slider(id, id + 2, value, {static_cast<double>(least), static_cast<double>(most)}, help);
            value = std::clamp(value, least, most);
        };
        whole("ζ", "##stencil-zeta", choice.zeta, 0, SchemeSet::max_zeta, std::floor(0.8f * width),
              {"Parametric size ζ",
               "How many particles there are along each axis. 0 is the node alone: plain semi-Lagrangian.",
               "0 to 4", "thesis sec. 4.1, table 4.1", ""});
        whole("Seed", "##stencil-seed", choice.seed, 1, 99, -FLT_MIN,
              {"Seed", "Another one gives another set of jittered particles.", "1 to 99",
               "after thesis ch. 6", jittered ? "" : "Only jittered particles are drawn by lot."});
    }

    void particles_plot(ImVec2 size) {
        const Theme& theme = ui_.theme;
        const std::span<const Particle> particles = stencil_->particles();
        Plot plot;
        plot.title = "Particles of a node";
        plot.x_name = "x, cells from the node";
        plot.size = size;
        const double reach = 1.12;
        const LegendEntry legend[] = {{"particles, by weight", theme.palette.accent, true},
                                      {"of neighbours", theme.palette.text_dim, true}};
        const double up = choice_.dimensions == 1 ? 0.3 : reach;
        const Canvas canvas(theme, plot, legend, {-reach, reach}, {-up, up}, Canvas::Units::Equal);
        ui_.log.control("stencil-particles");
        if (!canvas) return;
        draw_grid(theme, canvas, choice_.dimensions);
        draw_neighbours(theme, canvas, *stencil_, choice_.dimensions);
        const double most = Summary(particles).most;
        const Particle* under = nullptr;
        for (const Particle& particle : particles) {
            const auto x = static_cast<double>(particle.offset.x), y = static_cast<double>(particle.offset.y);
            const auto part = static_cast<float>(static_cast<double>(particle.weight) / most);
            const float radius = theme.px(largest_dot) * std::sqrt(part);
            canvas.dot(x, y, radius, faded(theme.palette.accent, 0.3f + 0.7f * part));
            const ImVec2 at = canvas.pixel(x, y);
            const ImVec2 mouse = ImGui::GetIO().MousePos;
            if (canvas.hovered() && std::hypot(at.x - mouse.x, at.y - mouse.y) <= theme.px(largest_dot))
                under = &particle;
        }
        const std::string what = under != nullptr ? describe(*under, choice_.dimensions)
                                                  : "Where each node's particles start, as large as they "
                                                    "count. The frame is the node's cell, the "
                                                    "dashes are the circle of radius Δ_r. A particle inside "
                                                    "a ring is also one of a neighbour's.";
        ui_.tooltip.item(
            theme, "stencil-particles" + what,
            {under != nullptr ? "Particle" : "Particles", what, "", "thesis fig. 4.2, table 4.1", ""});
    }

    /// The weights as curves, those of the particles themselves as dots on the chosen one.
    void weights_plot(ImVec2 size) {
        const Theme& theme = ui_.theme;
        const std::size_t kinds = WeightKernel::list().all().size();
        constexpr int samples = 160;
        const double radius = Stencil::radius(choice_.dimensions);
        std::vector<float> x;
        std::vector<std::vector<float>> y(kinds);
        std::vector<LegendEntry> legend;
        Extent extent;
        extent.add(std::array{0.0f});
        for (int m = 0; m <= samples; ++m) x.push_back(static_cast<float>(radius * (2.0 * m / samples - 1)));
        for (std::size_t k = 0; k < kinds; ++k) {
            const auto kind = Id<WeightKernel>::at(k);
            const WeightProfile profile(*stencil_, choice_.dimensions, kind);
            for (const float r : x)
                y[k].push_back(static_cast<float>(profile(std::abs(static_cast<double>(r)))));
            extent.add(y[k]);
            legend.push_back({kind.info().label, theme.palette.series[k % theme.palette.series.size()]});
        }
        Plot plot;
        plot.title = "Weights";
        plot.x_name = "distance, cells";
        plot.size = size;
        const Canvas canvas(theme, plot, legend, {-1.06 * radius, 1.06 * radius}, extent.fitted());
        ui_.log.control("stencil-profile");
        if (!canvas) return;
        const std::size_t chosen = choice_.weights.index();
        for (std::size_t k = 0; k < kinds; ++k) {
            canvas.curve(x, y[k], theme.palette.series[k % theme.palette.series.size()],
                         k == chosen ? 2 * curve_thickness(theme) : curve_thickness(theme));
        }
        for (const Particle& particle : stencil_->particles()) {
            const double side = particle.offset.x < 0 ? -1 : 1;
            canvas.dot(side * distance(particle), static_cast<double>(particle.weight), theme.px(3),
                       theme.palette.series[chosen % theme.palette.series.size()]);
        }
        ui_.tooltip.item(theme, "stencil-profile",
                         {"Weights by distance",
                          "All kinds of weights, scaled so that those of this stencil sum to "
                          "1. Dots are the particles, on the side of the node where they lie.",
                          "", "thesis eq. 4.4–4.9, fig. 4.3", ""});
    }

    Ui& ui_;
    StencilChoice choice_;
    StencilChoice made_;  ///< what stencil_ was made for
    std::optional<Stencil> stencil_;
};

}  // namespace

const LabEntry stencil_lab{
    .key = "stencil",
    .label = "Stencil lab",
    .help = "The particles that ASLAM traces for a node, and how much each counts.",
    .source = "thesis fig. 4.2, 4.3, table 4.1",
    .width = 920,
    .height = 560,
    .anchor = LabEntry::Anchor::Middle,
    .make = [](const Services& s) -> std::unique_ptr<Lab> { return std::make_unique<StencilLab>(s.ui); }};

}  // namespace whorl::app
