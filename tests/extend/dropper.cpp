// An edit that drops dye, the tool that makes such edits, and a panel with a button for it.
#include <imgui.h>

#include "app/run/run_control.h"
#include "app/ui/ui.h"
#include "core/sources/stroke.h"
#include "tests/extend/additions.h"

namespace whorl::test {
namespace {

constexpr std::string_view numbers[] = {"x", "y", "radius"};

/// Fills the cells around (x, y) with dye.
CellRange apply(const Edit& edit, State& state, const Scene&) {
    const Segment at{edit.numbers[0], edit.numbers[1], edit.numbers[0], edit.numbers[1]};
    Field& field = state[dye()];
    double change = 0;
    for_samples_near(at, edit.numbers[2], field, state.grid(), [&](int i, int j, double) {
        if (state.boundary.solid(i, j)) return;
        change += 1 - static_cast<double>(field(i, j));
        field(i, j) = 1;
    });
    state.injected[scalar_index(dye())] += change * state.grid().cell();
    state.boundary.fill(field);
    return cells_near(at, edit.numbers[2], state.grid());
}

void drop_in_the_middle(app::RunControl& run) {
    const Grid grid = run.scene().grid();
    run.push(Edit{drop, {grid.nx * grid.h / 2, grid.ny * grid.h / 2, 4 * grid.h}});
}

constexpr app::KeyHelp keys[] = {{"J", "a drop of dye in the domain's middle"}};

class Dropper final : public app::Tool {
  public:
    explicit Dropper(app::RunControl& run) : run_(run) {}
    bool take(const app::InputEvent& event, const app::FieldViewports&) override {
        if (event.kind != app::InputEvent::Kind::Character || event.code != 'j') return false;
        drop_in_the_middle(run_);
        return true;
    }

  private:
    app::RunControl& run_;
};

class DyePanel final : public app::Panel {
  public:
    DyePanel(app::Ui& ui, app::RunControl& run) : ui_(ui), run_(run) {}
    void draw() override {
        if (ui_.button("Drop", "drop-dye", ImGui::GetContentRegionAvail().x,
                       {"Drop", "A drop of dye in the domain's middle. Key: J", "", "", ""}))
            drop_in_the_middle(run_);
    }

  private:
    app::Ui& ui_;
    app::RunControl& run_;
};

}  // namespace

constinit const EditVerb drop{
    .info{"drop", "Drop", "a test", "Fills a disc with dye."}, .numbers = numbers, .apply = apply};

const app::ToolEntry dropper{.key = "dropper", .mouse = {}, .keys = keys, .make = [](const app::Services& s) {
                                 return std::unique_ptr<app::Tool>(std::make_unique<Dropper>(s.run));
                             }};

const app::PanelEntry dye_panel{
    .key = "dye", .title = "Dye", .make = [](const app::Services& s) {
        return std::unique_ptr<app::Panel>(std::make_unique<DyePanel>(s.ui, s.run));
    }};

}  // namespace whorl::test
