#include "core/inspect/text.h"

#include <cmath>
#include <cstdio>
#include <string_view>

#include "core/base/number.h"

namespace whorl {
namespace {

/// Six figures; a zero has no sign.
std::string number(double value) {
    return significant(value, 6);
}

/// The same in a column.
std::string column(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%13.6g", value + 0.0);
    return text;
}

std::string point(WorldPoint p) {
    return "(" + number(p.x) + ", " + number(p.y) + ")";
}

std::string node(int i, int j) {
    return "(" + std::to_string(i) + ", " + std::to_string(j) + ")";
}

class Writer {
  public:
    std::string text;

    void write(const Explanation& e) {
        const FieldInfo& what = e.quantity.info();
        line(0, std::string(what.title) + " at " + node(e.i, e.j) + ": " + number(e.result));
        if (e.inside()) {
            line(1, "in a wall; holds the value of the nearest node that fluid touches, " +
                        node(e.of_i, e.of_j) + ", explained here");
        }
        if (e.closed) {
            line(1, "on a wall: no velocity across; without it the advection would give " +
                        number(e.sum.value()));
        }
        if (e.now != e.result) line(1, "since then it has become " + number(e.now));
        for (const BaseStep& step : e.steps) write(step);
        if (e.correction) write(*e.correction);
        text += '\n';
        write(e.sum, 0);
        line(0, e.limited() ? "a limiter acted" : "no limiter acted");
    }

  private:
    void line(int depth, const std::string& words) {
        text += std::string(static_cast<std::size_t>(2 * depth), ' ') + words + '\n';
    }

    void write(const BaseStep& step) {
        line(1,
             step.title + ": " + point(step.path.start) + " → " + point(step.path.end) + ", in length units");
        for (const Path::Stage& stage : step.path.stages) {
            line(2, "velocity at " + point(stage.at) + " is " + point({stage.u, stage.v}));
        }
        std::string others = "by euler " + point(step.euler.end) + ", midpoint " + point(step.midpoint.end);
        if (!step.fine.empty()) others += ", many small steps " + point(step.fine.back());
        line(2, others);
        line(2, "read at " + point(step.read) + ": node " + node(step.i, step.j) + " + " +
                    point({step.x, step.y}) + " cells");
        if (!step.particles.empty()) {
            line(2, std::to_string(step.particles.size()) + " particles; their weights summed to " +
                        number(step.weight_sum) + " before they were normalised to 1");
        }
        for (const StencilParticle& p : step.particles) {
            line(3, point(p.path.start) + " → " + point(p.path.end) + " gives " + number(p.contribution));
        }
    }

    void write(const Correction& c) {
        line(1, "start " + number(c.start) + ", forward " + number(c.forward) + ", back " + number(c.back) +
                    ", error " + number(c.error));
    }

    void write(const Sum& sum, int depth) {
        line(depth, sum.title + " = " + number(sum.value()) + "  [" + sum.equation + "]" +
                        (sum.units.empty() ? "" : "; " + sum.units));
        if (sum.slopes) write(*sum.slopes, depth + 1);
        for (const Term& term : sum.terms) {
            line(depth + 1, column(term.weight) + " ×" + column(term.value) + " =" + column(term.product()) +
                                "  " + term.label);
        }
        line(depth + 1, std::string(27, ' ') + "sum" + column(sum.total));
        if (sum.cut) write(*sum.cut, depth + 1);
        for (const Sum& part : sum.parts) write(part, depth + 1);
    }

    void write(const CubicSlopes& s, int depth) {
        line(depth, "D = " + number(s.D) + ", δᵢ = " + number(s.left) + ", δᵢ₊₁ = " + number(s.right) +
                        (s.D != 0 ? ", α = " + number(s.alpha()) + ", β = " + number(s.beta()) : ""));
        if (!s.changed()) return;
        line(depth, "limited: δᵢ = " + number(s.limited_left) + ", δᵢ₊₁ = " + number(s.limited_right) +
                        (s.D != 0 ? ", α = " + number(s.limited_alpha()) + ", β = " + number(s.limited_beta())
                                  : "") +
                        "  [" + s.equation + "]");
    }

    void write(const Clamping& cut, int depth) {
        std::string words =
            cut.by + ": the enclosing nodes hold " + number(cut.low) + " … " + number(cut.high) + "; ";
        if (!cut.changed()) {
            words += "nothing to do";
        } else if (cut.first_order && cut.after == *cut.first_order) {
            words += "back to first order, " + number(cut.after);
        } else {
            words += "cut to " + number(cut.after);
        }
        line(depth, words + "  [" + cut.equation + "]");
    }
};

}  // namespace

std::string write_text(const Explanation& explanation) {
    Writer writer;
    writer.write(explanation);
    return std::move(writer.text);
}

}  // namespace whorl
