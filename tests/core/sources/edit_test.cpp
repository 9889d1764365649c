// A kind of edit is one entry: it acts, goes into run files and comes back, and replays bit by bit.
#include "core/sources/edit.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/experiments/experiment.h"
#include "core/io/run_file.h"
#include "core/scene/parameters.h"
#include "core/session/session.h"
#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"

namespace whorl {
namespace {

// ---- a verb of the tests' own

constexpr std::string_view stir_numbers[] = {"x", "y", "radius", "spin"};

void check_stir(const Edit& edit) {
    if (!(edit.numbers[2] > 0)) throw InputError("radius = " + shortest(edit.numbers[2]) + " is not above 0");
}

/// Adds a vortex around (x, y): `spin` is its angular velocity, and fades towards the radius.
CellRange stir(const Edit& edit, State& state, const Scene&) {
    const double x = edit.numbers[0], y = edit.numbers[1], radius = edit.numbers[2], spin = edit.numbers[3];
    const Segment at{x, y, x, y};
    FaceVelocity& velocity = state.velocity;
    const auto fade = [&](double distance) { return spin * (1 - distance / radius); };
    for_samples_near(at, radius, velocity.u, state.grid(), [&](int i, int j, double distance) {
        velocity.u(i, j) -= static_cast<Real>(fade(distance) * (world(velocity.u, state.grid(), i, j).y - y));
    });
    for_samples_near(at, radius, velocity.v, state.grid(), [&](int i, int j, double distance) {
        velocity.v(i, j) += static_cast<Real>(fade(distance) * (world(velocity.v, state.grid(), i, j).x - x));
    });
    state.boundary.enforce(velocity);
    return cells_near(at, radius, state.grid());
}

constexpr EditVerb stir_verb{
    .info{"stir", "Stir", "", "Adds a vortex."}, .numbers = stir_numbers, .check = check_stir, .apply = stir};

class Edits : public testing::Test {
  protected:
    void SetUp() override { EditVerb::list().add(stir_verb); }
    void TearDown() override { EditVerb::list().remove(stir_verb); }

    static Recording run() {
        Scene scene = scene_of(experiment("plume"));
        set_parameter(scene, "resolution=24");
        const Edit edit{stir_verb, {20.5, 12, 6, 0.75}};
        return {.setup = {.scene = scene},
                .commands = {{3, edit},
                             {5, SmokeStroke{.along = {5, 5, 30, 22}, .amounts = {{field::density, 1}}}},
                             {5, ObstacleStroke{.along = {8, 20, 30, 26}}},
                             {9, edit}},
                .step = 16};
    }
    static std::uint64_t replay(const Recording& recording, int threads) {
        Pool pool(threads);
        Session session(recording, pool);
        while (session.step_number() < recording.step) session.step();
        return session.digest();
    }
    static std::string refusal(const std::string& line) {
        try {
            parse_run("whorl = 1\ncommands = \"\"\"\n" + line + "\n\"\"\"\n", "run.toml");
        } catch (const InputError& e) {
            return e.what();
        }
        return {};
    }
};

TEST_F(Edits, AVerbActs) {
    Pool pool(1);
    Simulation simulation(run().setup.scene, pool);
    simulation.apply(Edit{stir_verb, {20, 20, 5, 2}});
    const FaceVelocity& velocity = simulation.state().velocity;
    EXPECT_GT(velocity.v(13, 12), 0);
    EXPECT_LT(velocity.v(10, 12), 0);
    simulation.step();
    EXPECT_GT(velocity.v(13, 12), 0);
}

TEST_F(Edits, AVerbGoesThroughRunFiles) {
    const Recording recording = run();
    const std::string text = write_run(recording);
    EXPECT_NE(
        text.find("\n3 stir 20.5 12 6 0.75\n5 smoke 5 5 30 22 2 1 0 0 0 0\n5 build 8 20 30 26 2\n9 stir"),
        std::string::npos)
        << text;
    EXPECT_EQ(parse_run(text, "run.toml"), recording);
}

TEST_F(Edits, AVerbReplaysBitByBit) {
    const Recording recording = run();
    const std::uint64_t digest = replay(recording, 1);
    EXPECT_EQ(replay(parse_run(write_run(recording), "run.toml"), 2), digest);
    Recording without = recording;
    std::erase_if(without.commands, [](const TimedCommand& s) {
        const auto* edit = std::get_if<Edit>(&s.command);
        return edit != nullptr && edit->verb == Id<EditVerb>(stir_verb);
    });
    EXPECT_NE(replay(without, 1), digest);

    Pool pool(2);
    Session session({.setup = recording.setup}, pool);
    for (const TimedCommand& timed : recording.commands) {
        while (session.step_number() < timed.step) session.step();
        session.apply(timed.command);
    }
    session.rewind(4);
    while (session.step_number() < recording.step) session.step();
    EXPECT_EQ(session.digest(), digest) << "as commands, and after a rewind";
}

TEST_F(Edits, WrongNumbersAreRefusedInALine) {
    const std::string at = "run.toml:2:12: command 1: ";
    EXPECT_EQ(refusal("3 stir 1 2 3 4"), "");
    EXPECT_EQ(refusal("3 stir 1 2 3"), at + "a number is missing");
    EXPECT_EQ(refusal("3 stir 1 2 3 4 5"), at + "\"5\" is too much");
    EXPECT_EQ(refusal("3 stir 1 2 3 density=4"), at + "\"density=4\" is not a number");
    EXPECT_EQ(refusal("3 stir 1 inf 3 4"), at + "\"inf\" is not finite");
    EXPECT_EQ(refusal("3 stir 1 2 -3 4"), at + "radius = -3 is not above 0");
    EXPECT_EQ(refusal("3 stur 1 2 3 4"), at + "unknown command \"stur\"; did you mean stir?");
    State state = make_state({});
    EXPECT_THROW(apply(Edit{stir_verb, {1, 2, 3}}, state, {}), std::invalid_argument);
    EXPECT_THROW(EditVerb::list().add(stir_verb), InputError);
}

TEST_F(Edits, AVerbIsGoneAfterItsTest) {
    EditVerb::list().remove(stir_verb);
    EXPECT_TRUE(refusal("3 stir 1 2 3 4").starts_with("run.toml:2:12: command 1: unknown command \"stir\""));
}

// ---- every verb

/// Where two fields differ is within the cells, or on their faces.
void expect_changed_within(const Field& before, const Field& after, const CellRange& cells) {
    const int back_i = before.site() == Site::FaceX ? 1 : 0;
    const int back_j = before.site() == Site::FaceY ? 1 : 0;
    for (int j = 0; j < before.height(); ++j) {
        for (int i = 0; i < before.width(); ++i) {
            const bool within = cells.contains(i, j) || cells.contains(i - back_i, j - back_j);
            EXPECT_TRUE(within || before(i, j) == after(i, j)) << i << ", " << j;
        }
    }
}

TEST_F(Edits, TellWhichCellsTheyTouched) {
    Scene scene;
    scene.resolution = 33;
    const SmokeStroke smoke{.along = {3, 30, 12, 21},
                            .radius = 3.3,
                            .amounts = {{field::density, 1}, {field::temperature, 60}},
                            .push = 1,
                            .velocity_x = 20,
                            .velocity_y = 5};
    SmokeStroke push = smoke;
    push.smoke = false;
    for (const Edit& edit :
         {Edit(smoke), Edit(push), Edit(ObstacleStroke{.along = {3, 30, 12, 21}}),
          Edit(ObstacleStroke{.along = {-9, 1, 60, 0}}), Edit{stir_verb, {20, 12, 6, 1}}}) {
        SCOPED_TRACE(edit.verb.key());
        State state = make_state(scene);
        state.velocity.u.set_all(1);
        state.velocity.v.set_all(-2);
        state.boundary.enforce(state.velocity);
        const State before = state;
        const CellRange cells = apply(edit, state, scene);
        for_each_field(
            before, [&](FieldId id, const Field& field) { expect_changed_within(field, state[id], cells); });
        for (int j = 0; j < scene.grid().ny; ++j) {
            for (int i = 0; i < scene.grid().nx; ++i) {
                EXPECT_TRUE(cells.contains(i, j) || !state.boundary.solid(i, j)) << i << ", " << j;
            }
        }
    }
}

TEST(CellRange, HoldsTheCellsThatARectangleMeets) {
    const Grid grid{8, 5, 0.5};
    EXPECT_EQ(cells_in(grid, 0.6, 0.5, 1.7, 1.0), (CellRange{1, 1, 4, 2}));
    EXPECT_EQ(cells_in(grid, -9, -1, 1e300, 0.1), (CellRange{0, 0, 8, 1}));
    EXPECT_EQ(cells_in(grid, 9, 9, 10, 10), (CellRange{8, 5, 8, 5}));
}

}  // namespace
}  // namespace whorl
