// Hostile scenes.
#include "core/base/error.h"
#include "core/experiments/experiment.h"
#include "core/io/run_file.h"
#include "core/scene/parameters.h"
#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"
#include "tests/fuzz/fuzz.h"

namespace whorl::fuzz {
namespace {

/// The reader under test.
void read(const std::string& text) {
    parse_run(text, input_name);
}

std::vector<std::string> corpus() {
    std::vector<std::string> texts{
        "whorl = 1\n", "whorl = 1\nvelocity.advector = \"aslam\"\n[scalars]\nlimiter = \"none\"\n"};
    // Tall: a word more, and it has billions of cells.
    texts.push_back("whorl = 1\nwidth = 1\nheight = 1000\nresolution = 16\n[[obstacle]]\nradius = 1\n");
    for (const Experiment& e : experiments()) {
        Scene scene = scene_of(e);
        scene.title = "ζ \"quoted\"\n";
        scene.emitters.resize(2);
        scene.obstacles.push_back({.radius = 2});
        scene.obstacles.push_back({.width = 3, .height = 1});
        texts.push_back(write_run({.setup = {.scene = scene}}));
    }
    Recording run;
    run.setup.lanes = {{.name = "one"}, {.overrides = {{"zeta", "3"}}, .refine = 2}};
    run.setup.reference = 1;
    run.commands = {{0, SmokeStroke{.along = {1, 2, 3, 4}, .amounts = {{field::density, 1}}}},
                    {3, SetParameter{"advector", "aslam"}},
                    {3, ObstacleStroke{}},
                    {9, Arrange{{LaneSetup{}, LaneSetup{.refine = 4}}, {0, 0}, 1}}};
    run.step = 12;
    run.digest = 0x1234;
    texts.push_back(write_run(run));
    return texts;
}

std::vector<std::string> dictionary() {
    std::vector<std::string> words{"[",
                                   "]",
                                   "{",
                                   "}",
                                   "a.",
                                   "\"\".",
                                   "=",
                                   ",",
                                   ".",
                                   "\"",
                                   "'",
                                   "\"\"\"",
                                   "'''",
                                   "#",
                                   "\n",
                                   "\r",
                                   "\\",
                                   "[[",
                                   "a={",
                                   "[a.",
                                   "x=[",
                                   "[1,",
                                   "{},",
                                   "[[a]]\n",
                                   "[a.b.c]\n",
                                   "a.b=1\n",
                                   "1e999",
                                   "-1e308",
                                   "nan",
                                   "inf",
                                   "-inf",
                                   "0x7fffffffffffffff",
                                   "2048",
                                   "1000",
                                   "9223372036854775807",
                                   "-9223372036854775808",
                                   "1_0",
                                   "0b1",
                                   "1979-05-27T07:32:00Z",
                                   "25:61:61",
                                   "\\u0000",
                                   "\\ud800",
                                   "\\U0010FFFF",
                                   "\xef\xbb\xbf",
                                   "\xff",
                                   "\xce",
                                   "\xf4\x90\x80\x80",
                                   std::string(1, '\0'),
                                   "\x7f",
                                   "true",
                                   "resolution = 2048\n",
                                   "height = 1000\n",
                                   "width = 1\n",
                                   "[[emitter]]\n",
                                   "[[obstacle]]\nradius = 1\n",
                                   "emitter = []\n",
                                   "whorl = 1\n",
                                   "velocity.",
                                   "scalars.",
                                   "commands = \"\"\"\n",
                                   "99999999999 smoke 1 2 3 4 5 6 7 8 9 10\n",
                                   "3 set zeta=3\n",
                                   "9 lanes 0\n",
                                   "9 build 1e308 1 1 1 1\n",
                                   "[[lane]]\n",
                                   "refine = 8\n",
                                   "[[arrangement]]\n",
                                   "[[arrangement.lane]]\n"};
    for (const Parameter& p : parameters()) {
        words.push_back(p.key);
        words.push_back(p.key + " = ");
        for (const SchemeInfo& choice : p.choices) words.push_back(std::string(choice.key));
    }
    return words;
}

}  // namespace
}  // namespace whorl::fuzz

int main(int argc, char** argv) {
    using namespace whorl;
    using namespace whorl::fuzz;
    const std::vector<std::string> texts = corpus(), words = dictionary();
    const auto mutate = [&](std::string& input, Random& random) {
        const std::size_t equals = input.find('=', random.below(input.size() + 1));
        if (random.one_in(3) && equals != input.npos) {  // another value for a key
            input.replace(equals + 1, input.find('\n', equals) - equals - 1, random.of(words));
        } else {
            mutate_bytes(input, random, texts, words);
        }
    };
    const auto refuse = [](const std::string& input) {
        return complaint_about<InputError>([&] { read(input); });
    };
    return run({"scene", texts, mutate, refuse}, argc, argv);
}
