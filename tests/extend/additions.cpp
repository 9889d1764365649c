#include "tests/extend/additions.h"

#include <cmath>

#include "app/run/run_control.h"
#include "app/run/tool.h"
#include "app/views/views.h"
#include "app/window/lists.h"
#include "core/measure/measure.h"
#include "core/sources/smoke_stroke.h"
#include "tests/extend/toys.h"

namespace whorl::test {
namespace {

using app::InputEvent;

// A scalar.

constexpr FieldInfo dye_info{.key = "dye",
                             .title = "Dye",
                             .symbol = "d",
                             .unit = "",
                             .counted = true,
                             .source = Source{.brush = 0.25, .emitter = 0.75},
                             .display = FieldDisplay{"Dye", "d", "How much dye there is.", "viridis"}};

// A measure.

const Measure dye_height{.key = "dye_height",
                         .title = "Height of the dye",
                         .unit = "length",
                         .help = "Mean height of the dye, ∫dy / ∫d",
                         .row =
                             [](const RowView& row, Sums& sums) {
                                 const Real* samples = row.state[dye()].row(row.j);
                                 for (const int i : row.fluid()) {
                                     sums[0] += static_cast<double>(samples[i]);
                                     sums[1] += static_cast<double>(samples[i]) * row.y;
                                 }
                             },
                         .value = [](const Measures&, const Sums& sums) { return sums[1] / sums[0]; }};

// A view.

const Field* root(const Snapshot& snapshot, Field& scratch) {
    if (!scratch.same_shape(snapshot.density())) scratch = snapshot.density();
    for (int j = 0; j < scratch.height(); ++j) {
        for (int i = 0; i < scratch.width(); ++i) scratch(i, j) = std::sqrt(snapshot.density()(i, j));
    }
    return &scratch;
}
const app::View root_density{
    {"Root of the density", "√ρ", "Shows thin smoke.", "magma", FieldDisplay::Middle::None, 15},
    "root-density",
    root};

// A tool.

constexpr app::KeyHelp dropper_keys[] = {{"J", "a drop of dye at the domain's middle"}};

class Dropper final : public app::Tool {
  public:
    explicit Dropper(app::RunControl& run) : run_(run) {}
    bool take(const InputEvent& event, const app::FieldViewports&) override {
        if (event.kind != InputEvent::Kind::Character || event.code != 'j') return false;
        const Grid grid = run_.scene().grid();
        const double x = grid.width() / 2, y = grid.height() / 2;
        run_.push(SmokeStroke{.along = {x, y, x, y}, .radius = 4 * grid.h, .amounts = {{dye(), 1}}});
        return true;
    }

  private:
    app::RunControl& run_;
};
const app::ToolEntry dropper{
    .key = "dropper", .mouse = {}, .keys = dropper_keys, .make = [](const app::Services& s) {
        return std::unique_ptr<app::Tool>(std::make_unique<Dropper>(s.run));
    }};

}  // namespace

FieldId dye() {
    static const FieldId id = find_field("dye");
    return id;
}

namespace {

/// Before the tests begin, and so before the first scene is made.
const bool listed = [] {
    add_scalar(dye_info);
    list_toys();
    measures().add(dye_height);
    app::add_view(root_density);
    app::tools().add(dropper);
    return true;
}();

}  // namespace
}  // namespace whorl::test
