// Edits: what changes fields or walls between two steps, as verbs with numbers.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/base/id.h"
#include "core/base/scheme_info.h"
#include "core/grid/cell_range.h"
#include "core/scene/state.h"

namespace whorl {

struct Edit;

/// A kind of edit. Its key is its verb in run files: neither `set` nor `lanes`, which are the session's.
struct EditVerb {
    SchemeInfo info;
    std::span<const std::string_view> numbers;  ///< what each is called, in the order of run files
    /// Whether amounts may follow as KEY=VALUE, of the scalars that no number is called after.
    bool takes_amounts = false;
    bool changes_walls = false;  ///< makes cells solid or fluid; others change fields alone
    /// Null where any finite numbers will do.  @throws InputError
    void (*check)(const Edit&) = nullptr;
    /// @return the cells whose fluid, faces included, it may have changed
    CellRange (*apply)(const Edit&, State&, const Scene&) = nullptr;

    /// All verbs.
    static Registry<EditVerb>& list();
};

struct Edit {
    Id<EditVerb> verb;
    std::vector<double> numbers;  ///< in the verb's order
    Amounts amounts{};            ///< of scalars that the numbers leave out
    bool operator==(const Edit&) const = default;
};

/// @return as EditVerb::apply
/// @throws std::invalid_argument if the verb takes more or fewer numbers
CellRange apply(const Edit& edit, State& state, const Scene& scene);

/// Whether an amount of a scalar is among a verb's numbers.
bool has_number(const EditVerb& verb, FieldId scalar);

}  // namespace whorl
