// Fields that are worked out of a state: what can be looked at beside what a run carries.
#pragma once

#include "core/base/registry.h"
#include "core/parallel/pool.h"
#include "core/scene/state.h"

namespace whorl {

/// A field at cell centres that a state determines.
struct DerivedField {
    std::string_view key;
    FieldDisplay display;
    /// @param out  of the grid's shape; ghosts may be left alone
    void (*compute)(const State&, Pool&, Field& out);
};

/// All of them, in the order of menus.
Registry<DerivedField>& derived_fields();

}  // namespace whorl
