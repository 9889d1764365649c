#include "core/inspect/explain.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "core/base/error.h"
#include "core/inspect/base_step.h"
#include "core/inspect/interpolation_sum.h"
#include "core/inspect/walls.h"

namespace whorl {
namespace {

/// The explanation of a node that walls leave alone.
class Explainer {
  public:
    Explainer(const LastAdvection& last, FieldId quantity, Pool& pool, Explanation& out)
        : last_(last),
          schemes_(last.setup.schemes(quantity)),
          q_{last.from(quantity), std::string(quantity.info().symbol)},
          stepper_(schemes_, last),
          pool_(pool),
          out_(out) {}

    void explain() {
        if (schemes_.predictor_corrector()) {
            correct();
        } else {
            NodeStep forward = step(q_, 1, "back along the flow");
            if (schemes_.affine())
                stepper_.limit(*q_.field, forward.cell, forward.first_order, forward.sum, forward.value);
            out_.sum = std::move(forward.sum);
        }
        out_.result = out_.sum.value();
    }

  private:
    NodeStep step(const Stepping& from, Real direction, const char* title) {
        NodeStep step = stepper_.step(from, out_.of_i, out_.of_j, direction);
        step.drawn.title = title;
        out_.steps.push_back(step.drawn);
        return step;
    }
    NodeStep base_step(const Stepping& from, Real direction, const char* title) {
        NodeStep base = step(from, direction, title);
        stepper_.limit_base(*from.field, base);
        return base;
    }

    void correct() {
        const bool again = schemes_.advector == Advectors::of<Bfecc>();
        Mover mover;
        Field moved = unlimited(mover);
        const Workspace& way = mover.workspace(0);
        const Real start = (*q_.field)(out_.of_i, out_.of_j);

        NodeStep forward = base_step(q_, 1, "forward");
        forward.sum.title = name("forward");
        NodeStep back = base_step({&way.forward[0], name("forward")}, -1, "back again");
        back.sum.title = name("back");
        const Real lost = (back.value - start) * Real(0.5);
        out_.correction = {static_cast<double>(start), static_cast<double>(forward.value),
                           static_cast<double>(back.value), static_cast<double>(lost)};
        Sum error{.title = "error e",
                  .equation = thesis_part(schemes_.advector.info().source) + ", step 3",
                  .terms = {{name("back"), 0.5, static_cast<double>(back.value)},
                            {q_.symbol + " before", -0.5, static_cast<double>(start)}},
                  .total = static_cast<double>(lost)};
        Sum& sum = out_.sum;
        sum.title = q_.symbol + " after advection";
        sum.equation = thesis_part(schemes_.advector.info().source);
        Real value = moved(out_.of_i, out_.of_j);
        sum.total = static_cast<double>(value);
        std::vector<Sum> later;
        if (again) {
            NodeStep last = base_step({&way.corrected[0], name("corrected")}, 1, "forward, corrected");
            last.sum.title = name("corrected") + ", moved forward";
            Sum corrected{.title = name("corrected") + " at the node",
                          .equation = "thesis alg. 3.2, step 4",
                          .terms = {{q_.symbol + " before", 1, static_cast<double>(start)},
                                    {"error e", -1, static_cast<double>(lost)}},
                          .total = static_cast<double>(way.corrected[0](out_.of_i, out_.of_j))};
            sum.terms = {{last.sum.title, 1, static_cast<double>(last.value)}};
            sum.equation += ", step 5";
            later = {std::move(corrected), std::move(last.sum)};
        } else {
            sum.equation += ", eq. 3.26";
            sum.terms = {{name("forward"), 1, static_cast<double>(forward.value)},
                         {"error e", -1, static_cast<double>(lost)}};
        }
        stepper_.limit(*q_.field, forward.cell, forward.value, sum, value);
        sum.parts = {std::move(forward.sum), std::move(back.sum), std::move(error)};
        std::move(later.begin(), later.end(), std::back_inserter(sum.parts));
    }

    /// The whole field as the scheme moves it without its limiter; the mover then has its way there.
    Field unlimited(Mover& mover) {
        SchemeSet schemes = schemes_;
        schemes.limiter = Limiters::of<NoLimiter>();
        mover.set(schemes, last_.boundary->grid().dimensions(), last_.setup.seed);
        Field moved = last_.boundary->field(q_.field->site());
        mover.advect(*q_.field, moved, *last_.velocity, last_.setup.dt, *last_.boundary, pool_);
        return moved;
    }

    std::string name(const char* which) const { return q_.symbol + " " + which; }

    const LastAdvection& last_;
    SchemeSet schemes_;
    Stepping q_;
    NodeStepper stepper_;
    Pool& pool_;
    Explanation& out_;
};

bool acted(const Sum& sum) {
    return (sum.cut && sum.cut->acted()) || std::any_of(sum.parts.begin(), sum.parts.end(), acted);
}

}  // namespace

bool Explanation::limited() const {
    return acted(sum);
}

Explanation explain(const LastAdvection& last, FieldId quantity, int i, int j, Pool& pool) {
    const Field* q = last.from(quantity);
    const std::string key(quantity.info().key);
    if (q == nullptr)
        throw InputError(key + " is not advected here: the flow is prescribed; ask for density");
    if (i < 0 || j < 0 || i >= q->width() || j >= q->height()) {
        throw InputError("(" + std::to_string(i) + ", " + std::to_string(j) + ") is no node of " + key +
                         ", which has " + std::to_string(q->width()) + " × " + std::to_string(q->height()) +
                         ", counted from 0");
    }
    flush_denormals();
    Explanation out;
    out.quantity = quantity;
    out.i = i;
    out.j = j;
    const WallRules walls(*last.boundary, q->site());
    std::tie(out.of_i, out.of_j) = walls.source(i, j);
    out.closed = walls.closed(i, j);
    out.at = world(*q, last.boundary->grid(), out.of_i, out.of_j);
    Explainer(last, quantity, pool, out).explain();
    if (out.closed) out.result = 0;
    out.now = static_cast<double>((*last.at_present(quantity))(i, j));
    return out;
}

}  // namespace whorl
