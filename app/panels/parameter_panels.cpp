// Panels that hold the controls of one group of parameters, and nothing else.
#include "app/panels/list.h"
#include "app/panels/parameter_control.h"

namespace whorl::app {
namespace {

class ParameterPanel final : public Panel {
  public:
    ParameterPanel(Ui& ui, RunControl& run, Parameter::Group group) : controls_(ui, run), group_(group) {}

    void draw() override { controls_.rows(group_); }

  private:
    ParameterControls controls_;
    Parameter::Group group_;
};

template <Parameter::Group group>
std::unique_ptr<Panel> make(const Services& s) {
    return std::make_unique<ParameterPanel>(s.ui, s.run, group);
}

}  // namespace

const PanelEntry particles_panel{
    .key = "particles", .title = "Particles", .make = make<Parameter::Group::Particles>};
const PanelEntry forces_panel{.key = "forces", .title = "Forces", .make = make<Parameter::Group::Forces>};
const PanelEntry brush_panel{.key = "brush", .title = "Brush", .make = make<Parameter::Group::Brush>};
const PanelEntry time_panel{.key = "time", .title = "Time", .make = make<Parameter::Group::Time>};
const PanelEntry domain_panel{.key = "domain", .title = "Domain", .make = make<Parameter::Group::Domain>};

}  // namespace whorl::app
