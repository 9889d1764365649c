// A view of what a snapshot holds, and a field that a state determines, which has a view of its own.
#include <cmath>

#include "tests/extend/additions.h"

namespace whorl::test {
namespace {

const Field* root(const Snapshot& snapshot, Field& scratch) {
    if (!scratch.same_shape(snapshot.density())) scratch = snapshot.density();
    for (int j = 0; j < scratch.height(); ++j) {
        for (int i = 0; i < scratch.width(); ++i) scratch(i, j) = std::sqrt(snapshot.density()(i, j));
    }
    return &scratch;
}

/// ½|u|² at cell centres.
void compute_kinetic(const State& state, Pool& pool, Field& out) {
    pool.bands(out.height(), [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < out.width(); ++i) {
                const Real x = (state.velocity.u(i, j) + state.velocity.u(i + 1, j)) / 2;
                const Real y = (state.velocity.v(i, j) + state.velocity.v(i, j + 1)) / 2;
                out(i, j) = (x * x + y * y) / 2;
            }
        }
    });
}

}  // namespace

const app::View root_density{
    {"Root of the density", "√ρ", "Shows thin smoke.", "magma", FieldDisplay::Middle::None, 15},
    "root-density",
    root};

const DerivedField kinetic{
    "kinetic",
    {"Kinetic energy", "length²/time²", "½|u|² at cell centres.", "viridis", FieldDisplay::Middle::None, 35},
    compute_kinetic};

}  // namespace whorl::test
