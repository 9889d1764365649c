#include "app/panels/quantity.h"

namespace whorl::app {
namespace {

const Field& difference(const Snapshot& s, Field& scratch) {
    if (!scratch.same_shape(s.density)) scratch = s.density;
    for (int j = 0; j < s.density.height(); ++j) {
        for (int i = 0; i < s.density.width(); ++i) scratch(i, j) = s.density(i, j) - s.exact(i, j);
    }
    return scratch;
}

constexpr auto from_zero = Quantity::Scale::FromZero;
constexpr auto about_zero = Quantity::Scale::AboutZero;
constexpr auto about_ambient = Quantity::Scale::AboutAmbient;

using Source = const Field& (*)(const Snapshot&, Field&);

template <Field Snapshot::*member>
constexpr Source of = [](const Snapshot& s, Field&) -> const Field& { return s.*member; };

constexpr Quantity table[] = {
    {"density", "Density", "", "Smoke density ρ.", from_zero, 0.5f, false, of<&Snapshot::density>},
    {"temperature", "Temperature", "degrees", "Temperature T, on either side of the ambient one.",
     about_ambient, 45.0f, false, of<&Snapshot::temperature>},
    {"speed", "Speed", "length/time", "Speed |u| at cell centres.", from_zero, 1.0f, false,
     of<&Snapshot::speed>},
    {"vorticity", "Vorticity", "1/time", "Vorticity ω = ∂v/∂x − ∂u/∂y.", about_zero, 1.0f, false,
     of<&Snapshot::vorticity>},
    {"pressure", "Pressure", "density·length²/time²", "Pressure p of the last projection.", about_zero, 1.0f,
     false, of<&Snapshot::pressure>},
    {"divergence", "Divergence", "1/time", "Divergence ∇·u of the velocity as it stands after the step.",
     about_zero, 0.01f, false, of<&Snapshot::divergence>},
    {"exact", "Exact", "", "The exact density.", from_zero, 1.0f, true, of<&Snapshot::exact>},
    {"difference", "Difference", "", "Numerical minus exact density.", about_zero, 0.1f, true, difference},
};

}  // namespace

std::span<const Quantity> quantities() {
    return table;
}

}  // namespace whorl::app
