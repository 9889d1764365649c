// A whole step allocates nothing once a run has settled.
#include <gtest/gtest.h>

#include "core/scene/parameters.h"
#include "core/simulation/simulation.h"
#include "tests/support/allocations.h"

namespace whorl {
namespace {

TEST(Step, AllocatesNothingOnceSettled) {
    for (const Experiment& e : experiments()) {
        for (const Advector* advector : Advector::list().all()) {
            Scene scene = scene_of(e);
            set_parameter(scene, "advector", advector->info.key);
            if (scene.dimensions == 2) set_parameter(scene, "resolution=48");
            scene.confinement = 1;
            if (e.flow == nullptr) scene.obstacles = {{.x = 20, .y = 20, .radius = 4}};
            Pool pool(2);
            Simulation simulation(scene, pool);
            for (int k = 0; k < 3; ++k) simulation.step();
            const long before = test::allocations();
            for (int k = 0; k < 5; ++k) simulation.step();
            EXPECT_EQ(test::allocations(), before) << e.info.key << " by " << advector->info.key;
        }
    }
}

}  // namespace
}  // namespace whorl
