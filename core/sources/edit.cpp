#include "core/sources/edit.h"

#include <algorithm>
#include <stdexcept>

namespace whorl {

CellRange apply(const Edit& edit, State& state, const Scene& scene) {
    if (edit.numbers.size() != edit.verb->numbers.size())
        throw std::invalid_argument(std::string(edit.verb.key()) + " takes " +
                                    std::to_string(edit.verb->numbers.size()) + " numbers");
    return edit.verb->apply(edit, state, scene);
}

bool has_number(const EditVerb& verb, FieldId scalar) {
    return std::find(verb.numbers.begin(), verb.numbers.end(), scalar.info().key) != verb.numbers.end();
}

}  // namespace whorl
