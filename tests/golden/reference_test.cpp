// Every scheme against an independent program's results.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "core/scene/parameters.h"
#include "core/simulation/simulation.h"

namespace whorl {
namespace {

/// The same formulas in another program, another order of operations and another precision.
constexpr double relative = 0.005;
/// For errors near 0, where a share of them means nothing.
constexpr double absolute_floor = 1e-4;
/// Points of conservation.
constexpr double density_points = 0.2;

struct Expected {
    long step;
    double L1, L2, Linf, density;
};
struct Case {
    std::string name;
    std::string experiment;
    std::vector<std::string> settings;
    std::vector<Expected> rows;
};

/// Rows of one run stand together; what a column leaves empty has no meaning for its scheme.
std::vector<Case> read_cases() {
    std::ifstream file(WHORL_TEST_DATA "/golden/reference.csv");
    std::string line;
    std::getline(file, line);
    const char* keys[] = {"",        "advector", "base",    "interpolation", "clamped",   "tracer",
                          "stencil", "zeta",     "weights", "limiter",       "resolution"};
    std::vector<Case> cases;
    std::map<std::string, std::size_t> index;
    while (std::getline(file, line)) {
        std::vector<std::string> cell;
        std::stringstream stream(line);
        for (std::string part; std::getline(stream, part, ',');) cell.push_back(part);
        std::string id = cell[0];
        Case c;
        c.experiment = cell[0];
        for (std::size_t k = 1; k <= 10; ++k) {
            if (cell[k].empty()) continue;
            c.settings.push_back(std::string(keys[k]) + "=" + cell[k]);
            id += "_" + cell[k];
        }
        for (char& letter : id) {
            if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
        }
        c.name = id;
        const auto [place, added] = index.try_emplace(id, cases.size());
        if (added) cases.push_back(c);
        cases[place->second].rows.push_back({std::stol(cell[11]), std::stod(cell[12]), std::stod(cell[13]),
                                             std::stod(cell[14]), std::stod(cell[15])});
    }
    return cases;
}

class Reference : public testing::TestWithParam<Case> {};

void expect_near(const char* what, double measured, double expected, long step) {
    EXPECT_NEAR(measured, expected, std::max(absolute_floor, relative * std::abs(expected)))
        << what << " at step " << step;
}

TEST_P(Reference, HoldsAtEveryStep) {
    const Case& c = GetParam();
    Scene scene = scene_of(experiment(c.experiment));
    for (const std::string& setting : c.settings) set_parameter(scene, setting);
    Pool pool(2);
    Simulation simulation(scene, pool);
    for (const Expected& row : c.rows) {
        while (simulation.state().step < row.step) simulation.step();
        const Measures& m = simulation.measures();
        expect_near("L1", m.errors.L1, row.L1, row.step);
        expect_near("L2", m.errors.L2, row.L2, row.step);
        expect_near("Linf", m.errors.Linf, row.Linf, row.step);
        EXPECT_NEAR(m.density_percent(), row.density, density_points) << "at step " << row.step;
    }
}

INSTANTIATE_TEST_SUITE_P(Csv, Reference, testing::ValuesIn(read_cases()),
                         [](const auto& run) { return run.param.name; });

}  // namespace
}  // namespace whorl
