#include "core/inspect/interpolation_sum.h"

#include <algorithm>

namespace whorl {
namespace {

/// Samples i − 1 … i + 2, for schemes that read two of them too.
using Samples = std::array<Real, 4>;
using Names = std::array<std::string, 4>;

/// One axis at a place.
struct Along {
    Real t;
    Interval in;
};

/// The scheme's weights: what it makes of samples that are 1 and 0.
Samples weights(const Interpolation& scheme, const Along& a) {
    Samples w{};
    for (std::size_t k = 0; k < w.size(); ++k) {
        Samples unit{};
        unit[k] = 1;
        w[k] = scheme.at(unit, a.t, a.in);
    }
    return w;
}

/// A general equation of the thesis, and a scheme's own: "thesis eq. 3.12, sec. A.1".
std::string equations(std::string_view general, std::string_view source) {
    std::string own = thesis_part(source);
    for (const std::string_view common : {"thesis ", "eq. "}) {
        if (own.starts_with(common)) own.erase(0, common.size());
    }
    return "thesis eq. " + std::string(general) + ", " + own;
}

/// One cubic as a sum over its end values and limited slopes.
Sum cubic_sum(const Interpolation& scheme, std::string title, const Names& names, const Samples& q,
              const Along& a) {
    const Slopes<Real> d(q[0], q[1], q[2], q[3]);
    const Slopes<Real> limited = scheme.limited(d);
    const auto term = [](std::string label, Real weight, Real factor) {
        return Term{std::move(label), static_cast<double>(weight), static_cast<double>(factor)};
    };
    Sum sum;
    sum.title = std::move(title);
    sum.equation = equations("3.12", scheme.info.source);
    // A cubic is linear in what it is given: its weights are what it makes of 1 and 0.
    sum.terms = {term(names[1], hermite<Real>(1, -1, 0, 0, a.t), q[1]),
                 term(names[2], hermite<Real>(0, 1, 0, 0, a.t), q[2]),
                 term("δᵢ", hermite<Real>(0, 0, 1, 0, a.t), limited.left),
                 term("δᵢ₊₁", hermite<Real>(0, 0, 0, 1, a.t), limited.right)};
    sum.total = static_cast<double>(scheme.at(q, a.t, a.in));
    sum.units = "slopes δ per cell";
    sum.slopes = CubicSlopes{static_cast<double>(d.D),           static_cast<double>(d.left),
                             static_cast<double>(d.right),       static_cast<double>(limited.left),
                             static_cast<double>(limited.right), equations("3.15", scheme.info.source)};
    return sum;
}

/// The 4 × 4 samples around a point, and how the scheme goes through them.
class Patch {
  public:
    Patch(const Interpolation& scheme, const Field& q, std::string_view symbol, const Boundary& boundary,
          const PointInCell& at, bool x_first)
        : scheme_(scheme),
          q_(q),
          symbol_(symbol),
          boundary_(boundary),
          at_(at),
          x_first_(x_first || q.height() == 1) {
        along_x_ = {at.x, {at.i, q.width() - 1, boundary.wraps().x}};
        along_y_ = {at.y, {at.j, q.height() - 1, boundary.wraps().y}};
    }

    /// The nodes that are read, with their weights where they have some. A single row is read along x alone.
    std::vector<KernelNode> nodes() const {
        const Samples wx = weights(scheme_, along_x_), wy = weights(scheme_, along_y_);
        std::vector<KernelNode> nodes;
        for (std::size_t b = first(); b < last(); ++b) {
            if (single_row() && row(b) != 0) continue;
            for (std::size_t a = first(); a < last(); ++a) {
                const int i = column(a), j = row(b);
                const double weight =
                    static_cast<double>(wx[a]) * (single_row() ? 1 : static_cast<double>(wy[b]));
                nodes.push_back({i, j, world(q_, boundary_.grid(), i, j), static_cast<double>(q_(i, j)),
                                 scheme_.traits.weighted_sum ? std::optional(weight) : std::nullopt});
            }
        }
        return nodes;
    }

    Sum weighted(const std::vector<KernelNode>& nodes) const {
        Sum sum;
        sum.equation = equations(single_row() ? "3.6" : "3.6–3.7", scheme_.info.source);
        for (const KernelNode& node : nodes)
            sum.terms.push_back({name(node.i, node.j), *node.weight, node.value});
        return sum;
    }

    /// Along the second axis through the values of cubics along the first.
    Sum cubics() const {
        if (single_row()) return first_axis(1 - at_.j);
        std::vector<Sum> parts;
        Names names;
        Samples values{};
        for (std::size_t k = 0; k < values.size(); ++k) {
            parts.push_back(first_axis(static_cast<int>(k)));
            names[k] = std::string(symbol_) + (x_first_ ? " in row " : " in column ") +
                       std::to_string(x_first_ ? row(k) : column(k));
            values[k] = pass(static_cast<int>(k));
        }
        Sum sum = cubic_sum(scheme_, x_first_ ? "along y" : "along x", names, values, second());
        sum.parts = std::move(parts);
        return sum;
    }

  private:
    /// What it reads, of four samples.
    std::size_t first() const { return scheme_.traits.samples == 2 ? 1 : 0; }
    std::size_t last() const { return scheme_.traits.samples == 2 ? 3 : 4; }

    bool single_row() const { return q_.height() == 1; }
    int column(std::size_t a) const { return at_.i - 1 + static_cast<int>(a); }
    int row(std::size_t b) const { return at_.j - 1 + static_cast<int>(b); }
    std::string name(int i, int j) const { return node_name(symbol_, q_, boundary_, i, j); }
    const Along& second() const { return x_first_ ? along_y_ : along_x_; }

    /// The samples of row or column k along the first axis.
    Samples line(int k) const {
        Samples q{};
        for (std::size_t a = first(); a < last(); ++a) {
            q[a] = x_first_ ? q_(column(a), row(static_cast<std::size_t>(k)))
                            : q_(column(static_cast<std::size_t>(k)), row(a));
        }
        return q;
    }
    Real pass(int k) const {
        const Along& a = x_first_ ? along_x_ : along_y_;
        return scheme_.at(line(k), a.t, a.in);
    }
    Sum first_axis(int k) const {
        Names names;
        for (std::size_t a = 0; a < names.size(); ++a) {
            names[a] = x_first_ ? name(column(a), row(static_cast<std::size_t>(k)))
                                : name(column(static_cast<std::size_t>(k)), row(a));
        }
        const std::string title =
            x_first_ ? "along x in row " + std::to_string(row(static_cast<std::size_t>(k)))
                     : "along y in column " + std::to_string(column(static_cast<std::size_t>(k)));
        return cubic_sum(scheme_, title, names, line(k), x_first_ ? along_x_ : along_y_);
    }

    const Interpolation& scheme_;
    const Field& q_;
    std::string_view symbol_;
    const Boundary& boundary_;
    const PointInCell& at_;
    bool x_first_;
    Along along_x_, along_y_;
};

}  // namespace

std::string node_name(std::string_view symbol, const Field& q, const Boundary& boundary, int i, int j) {
    const auto wrap = [](int k, int n) { return (k % n + n) % n; };
    if (boundary.wraps().x) i = wrap(i, q.width());
    if (boundary.wraps().y) j = wrap(j, q.height());
    const bool outside = i < 0 || j < 0 || i >= q.width() || j >= q.height();
    const std::string name = std::string(symbol) + "(" + std::to_string(i) + ", " + std::to_string(j) + ")";
    return outside ? name + " behind the wall" : name;
}

Sum interpolation_sum(const Field& q, std::string_view symbol, const Boundary& boundary,
                      const SchemeSet& schemes, const PointInCell& at, Real value,
                      std::vector<KernelNode>& nodes) {
    const Interpolation& scheme = schemes.interpolation.entry();
    const Patch patch(scheme, q, symbol, boundary, at, schemes.axis_order->x_first);
    nodes = patch.nodes();
    const bool cubic = scheme.limited != nullptr;
    Sum whole;
    if (scheme.traits.weighted_sum) {
        whole = patch.weighted(nodes);
        if (cubic) whole.parts.push_back(patch.cubics());
    } else if (cubic) {
        whole = patch.cubics();
    } else {
        whole.equation = thesis_part(scheme.info.source);
        whole.terms = {{std::string(scheme.info.label), 1, static_cast<double>(value)}};
    }
    whole.total = static_cast<double>(value);
    return whole;
}

}  // namespace whorl
