// The last step of a run is told as it was, or not at all.
#include <gtest/gtest.h>

#include <functional>

#include "core/experiments/experiment.h"
#include "core/inspect/explain.h"
#include "core/scene/parameters.h"
#include "core/scene/step_order.h"
#include "core/simulation/simulation.h"
#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"

namespace whorl {
namespace {

/// The last step of a running scene.
void expect_told(const Simulation& simulation, bool projected_after) {
    const auto last = simulation.last_advection();
    ASSERT_TRUE(last);
    Pool pool(1);
    for (std::size_t k = 0; k < fields().size(); ++k) {
        const auto quantity = FieldId(k);
        const Field* q = last->from(quantity);
        if (q == nullptr) continue;
        const bool scalar = q->site() == Site::Centre;
        for (int j = 0; j < q->height(); j += 3) {
            for (int i = 0; i < q->width(); i += 2) {
                const Explanation e = explain(*last, quantity, i, j, pool);
                if (projected_after && !scalar) continue;  // that changes what advection gave
                EXPECT_EQ(e.result, e.now) << quantity.info().key << " at " << i << ", " << j;
            }
        }
    }
}

TEST(Inspect, TellsTheLastStepOfARun) {
    for (const char* order : {"order=thesis", "order=smoke"}) {
        for (const char* advector : {"advector=maccormack", "advector=bfecc", "advector=aslam"}) {
            for (const bool linked : {true, false}) {
                Scene scene = scene_of(experiment("plume"));
                for (const char* s : {"resolution=20", order, advector}) set_parameter(scene, s);
                if (!linked) set_parameter(scene, "velocity.zeta=3");
                scene.obstacles = {{.x = 20, .y = 15, .radius = 4}};
                Pool pool(2);
                Simulation simulation(scene, pool);
                EXPECT_FALSE(simulation.last_advection()) << "no step yet";
                for (int k = 0; k < 40; ++k) simulation.step();
                expect_told(simulation, step_orders().all()[scene.order]->info.key == "smoke");
            }
        }
    }
}

TEST(Inspect, TellsTheLastStepOfEveryExperiment) {
    for (const Experiment& e : experiments()) {
        Scene scene = scene_of(e);
        if (scene.dimensions == 2) set_parameter(scene, "resolution=16");
        Pool pool(1);
        Simulation simulation(scene, pool);
        for (int k = 0; k < 5; ++k) simulation.step();
        expect_told(simulation, step_orders().all()[scene.order]->info.key == "smoke");
        EXPECT_EQ(simulation.last_advection()->from(field::u) == nullptr, e.flow != nullptr);
    }
}

TEST(Inspect, SaysNothingOfFieldsThatWereChangedSince) {
    const auto stepped = [](const char* name, Pool& pool) {
        Scene scene = scene_of(experiment(name));
        set_parameter(scene, "resolution=16");
        Simulation simulation(scene, pool);
        simulation.step();
        return simulation;
    };
    Pool pool(1);
    const auto wall = [](Simulation& s) { s.apply(ObstacleStroke{.along = {8, 20, 30, 26}, .radius = 3}); };
    const auto smoke = [](Simulation& s) {
        s.apply(SmokeStroke{.along = {5, 5, 30, 22},
                            .radius = 3,
                            .amounts = {{field::density, 1}},
                            .push = 1,
                            .velocity_x = 20});
    };
    const auto resolve = [](Simulation& s) {
        Scene scene = s.scene();
        set_parameter(scene, "resolution=20");
        s.set(scene);
    };
    const auto restart = [](Simulation& s) { s.restart(); };
    const auto restore = [](Simulation& s) { s.restore(s.checkpoint()); };
    for (const std::function<void(Simulation&)>& change :
         std::initializer_list<std::function<void(Simulation&)>>{wall, resolve, restart, restore}) {
        Simulation s = stepped("plume", pool);
        ASSERT_TRUE(s.last_advection());
        change(s);
        EXPECT_FALSE(s.last_advection());
        s.step();
        expect_told(s, false);
    }
    Simulation pushed = stepped("rotation", pool);
    smoke(pushed);
    EXPECT_FALSE(pushed.last_advection()) << "the flow that moved the density was pushed";
    // What the advection began with is still there; the density has changed since.
    Simulation plume = stepped("plume", pool);
    smoke(plume);
    ASSERT_TRUE(plume.last_advection());
    const Explanation e = explain(*plume.last_advection(), field::density, 6, 5, pool);
    EXPECT_NE(e.now, e.result);
    // Other schemes act on the next step, and do not change what the last one did.
    Scene other = plume.scene();
    set_parameter(other, "advector=aslam");
    plume.set(other);
    EXPECT_EQ(explain(*plume.last_advection(), field::density, 6, 5, pool).result, e.result);
}

}  // namespace
}  // namespace whorl
