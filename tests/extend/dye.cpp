// A scalar that the flow carries, and a measure of it.
#include "tests/extend/additions.h"

namespace whorl::test {

const FieldInfo dye_info{.key = "dye",
                         .title = "Dye",
                         .symbol = "d",
                         .unit = "",
                         .counted = true,
                         .source = Source{.brush = 0.25, .emitter = 0.75},
                         .display = FieldDisplay{"Dye", "d", "How much dye there is.", "viridis"}};

FieldId dye() {
    static const FieldId id = find_field("dye");
    return id;
}

namespace {

/// Rows are added up in order, so that a sum does not depend on threads.
void add_row(const RowView& row, Sums& sums) {
    const Real* samples = row.state[dye()].row(row.j);
    for (const int i : row.fluid()) {
        sums[0] += static_cast<double>(samples[i]);
        sums[1] += static_cast<double>(samples[i]) * row.y;
    }
}

}  // namespace

const Measure dye_height{.key = "dye_height",
                         .title = "Height of the dye",
                         .unit = "length",
                         .help = "Mean height of the dye, ∫dy / ∫d",
                         .row = add_row,
                         .value = [](const Measures&, const Sums& sums) { return sums[1] / sums[0]; }};

}  // namespace whorl::test
