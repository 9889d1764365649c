// What only tests know: one entry of each kind that the program has a list of.
#pragma once

#include "core/scene/field_list.h"

namespace whorl::test {

/// The scalar that is added.
FieldId dye();

}  // namespace whorl::test
