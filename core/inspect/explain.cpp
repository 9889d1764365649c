#include "core/inspect/explain.h"

#include <algorithm>
#include <tuple>

#include "core/base/error.h"
#include "core/inspect/explainer.h"
#include "core/inspect/walls.h"

namespace whorl {
namespace {

bool acted(const Sum& sum) {
    return (sum.cut && sum.cut->changed()) || std::any_of(sum.parts.begin(), sum.parts.end(), acted);
}

}  // namespace

bool Explanation::limited() const {
    return acted(sum);
}

std::string unexplained(const SchemeSet& schemes) {
    if (AdvectorExplanation::list().seek(schemes.advector.key()) != nullptr) return {};
    return "there is no explanation of " + std::string(schemes.advector.info().label) +
           ": what its step reads is not known to the inspector";
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
    const SchemeSet& schemes = last.setup.schemes(quantity);
    if (const std::string reason = unexplained(schemes); !reason.empty()) throw InputError(reason);
    flush_denormals();
    Explanation out;
    out.quantity = quantity;
    out.i = i;
    out.j = j;
    const WallRules walls(*last.boundary, q->site());
    std::tie(out.of_i, out.of_j) = walls.source(i, j);
    out.closed = walls.closed(i, j);
    out.at = world(*q, last.boundary->grid(), out.of_i, out.of_j);
    Explainer explainer(last, quantity, pool, out);
    AdvectorExplanation::list().find(schemes.advector.key()).explain(explainer);
    out.result = out.sum.value();
    if (out.closed) out.result = 0;
    out.now = static_cast<double>((*last.at_present(quantity))(i, j));
    return out;
}

}  // namespace whorl
