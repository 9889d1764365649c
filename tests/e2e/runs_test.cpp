// Runs without a window: recorded, replayed, compared, filmed.
#include <algorithm>
#include <map>

#include "core/io/png.h"
#include "core/io/run_file.h"
#include "tests/support/command_line.h"

namespace whorl {
namespace {

/// A run of three lanes with a bit of everything in it, as the window records it.
constexpr const char* drawn_run = R"(whorl = 1
experiment = "plume"
resolution = 32
pressure = "ldlt"
step = 70
commands = """
0 smoke 5 5 30 22 3 1 60 1 20 5
12 set advector=maccormack
20 build 8 20 30 26 1.5
35 lanes 0
40 erase 8 20 14 22 2
50 set beta=0.5
"""

[[lane]]
name = "one"

[[lane]]
set = ["interpolation=fritsch-carlson", "dt=0.01"]

[[arrangement]]
reference = 1
[[arrangement.lane]]
from = 1
set = ["interpolation=fritsch-carlson"]
[[arrangement.lane]]
from = 0
refine = 2
[[arrangement.lane]]
from = 0
set = ["resolution=27"]
)";

std::string digest_in(const std::string& out) {
    const std::size_t at = out.find("digest: ");
    return at == out.npos ? "none" : out.substr(at + 8, 16);
}

TEST_F(CommandLine, ReplaysARunToTheSameBitsFromFilesAndPictures) {
    write("drawn.toml", drawn_run);
    const Outcome first = whorl("run drawn.toml --digest --save saved.toml --picture p.png --threads 2");
    ASSERT_EQ(first.code, 0) << first.out;
    EXPECT_NE(first.out.find("step 70"), std::string::npos) << first.out;
    for (const char* again : {"run drawn.toml --digest --threads 1", "run saved.toml --digest --threads 1",
                              "run p.png --digest --threads 2", "run ./p.png --digest --save again.toml"}) {
        const Outcome o = whorl(again);
        EXPECT_EQ(digest_in(o.out), digest_in(first.out)) << again << "\n" << o.out;
        const bool recorded = std::string(again).find("drawn") == std::string::npos;
        EXPECT_EQ(o.out.find("the same bits as were recorded") != o.out.npos, recorded) << o.out;
    }
    EXPECT_EQ(contents("again.toml"), contents("saved.toml"));
    EXPECT_EQ(whorl("run p.png --picture q.png").code, 0);
    EXPECT_EQ(contents("q.png"), contents("p.png")) << "run, picture, run: the same picture";
}

TEST_F(CommandLine, SaysWhenItIsNotWhatWasRecorded) {
    std::string run = drawn_run;
    run.insert(run.find("step ="), "digest = \"0123456789abcdef\"\n");
    write("other.toml", run);
    const Outcome o = whorl("run other.toml");
    EXPECT_NE(o.out.find("these are not the bits that were recorded"), std::string::npos);
    EXPECT_EQ(o.code, 1);
    EXPECT_EQ(whorl("run other.toml --set beta=0.1").out.find("recorded"), std::string::npos)
        << "who changes it knows";
}

TEST_F(CommandLine, WritesRowsOfEveryLane) {
    const Outcome o = whorl("run plume --lanes tracers --set resolution=16 --steps 3 --csv -");
    EXPECT_EQ(o.lines(), 13u) << o.out;
    EXPECT_TRUE(o.out.starts_with("lane,step,time,")) << o.out;
    EXPECT_NE(o.out.find("\nRK4,3,0.05,"), std::string::npos) << o.out;
    write("named.toml", "whorl = 1\n[[lane]]\nname = \"a, \\\"b\\\"\"\n[[lane]]\n");
    EXPECT_NE(whorl("run named.toml --steps 1 --csv -").out.find("\"a, \"\"b\"\"\",1,"), std::string::npos);
}

TEST_F(CommandLine, RowsKeepALanesNameWhereverItMoves) {
    write("drawn.toml", drawn_run);
    ASSERT_EQ(whorl("run drawn.toml --csv rows.csv --timing times.csv").code, 0);
    const std::string rows = contents("rows.csv");
    std::vector<std::string> names;  // of step 36, after the lanes have changed places and a third has come
    std::istringstream lines(rows);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t comma = line.find(',');
        if (line.compare(comma, 4, ",36,") == 0) names.push_back(line.substr(0, comma));
    }
    ASSERT_EQ(names.size(), 3u) << rows;
    EXPECT_NE(rows.find("\n" + names[0] + ",34,"), std::string::npos) << "the second lane until then";
    EXPECT_EQ(names[1], "one") << "the first lane until then";
    EXPECT_NE(names[2].find("27"), std::string::npos) << "by what differs: " << names[2];
    const std::string times = contents("times.csv");
    EXPECT_TRUE(times.starts_with("lane,phase,median_ms\n")) << times;
    for (const std::string& name : names)
        EXPECT_NE(times.find("\n" + name + ",total,"), std::string::npos) << times;
    // A run that begins with one lane and is given another one names both.
    write("one.toml",
          "whorl = 1\nexperiment = \"plume\"\nresolution = 16\nstep = 4\ncommands = \"\"\"\n2 lanes "
          "0\n\"\"\"\n[[arrangement]]\n[[arrangement.lane]]\nfrom = 0\n[[arrangement.lane]]\nfrom = 0\n");
    const Outcome one = whorl("run one.toml --csv -");
    EXPECT_TRUE(one.out.starts_with("lane,step,")) << one.out;
    EXPECT_EQ(one.lines(), 1u + 1 + 2 * 3) << one.out;
}

TEST_F(CommandLine, ASignalLeavesNothingHalfWritten) {
    for (const char* signal : {"TERM", "HUP"}) {
        const std::string script =
            "cd '" + folder.string() +
            "' && { '" WHORL_BINARY
            "' run plume --steps 1000000 --set resolution=16 --csv rows.csv --animate film-%d.png --every "
            "100000"
            " >/dev/null & p=$!; until ls | grep -q part-; do sleep 0.02; done; kill -" +
            signal + " $p; wait $p; [ $? -gt 128 ]; } 2>/dev/null";
        EXPECT_EQ(std::system(script.c_str()), 0) << signal << ": ended by the signal";
        for (const auto& left : fs::directory_iterator(folder))
            EXPECT_EQ(left.path().filename().string().find("part"), std::string::npos) << left.path();
    }
}

TEST_F(CommandLine, EveryVerbTakesAFileOrAPicture) {
    write("s.toml", "whorl = 1\nexperiment = \"translation\"\nresolution = 20\nsteps = 30\n");
    ASSERT_EQ(whorl("run s.toml --steps 2 --picture p.png").code, 0);
    for (const char* file : {"s.toml", "p.png"}) {
        EXPECT_EQ(whorl(std::string("run --steps 1 ") + file).code, 0);
        EXPECT_EQ(whorl(std::string("experiment --at 3 ") + file).code, 0);
        EXPECT_EQ(whorl(std::string("compare --lanes tracers --at 1 --csv - ") + file).code, 0);
        const Outcome o = whorl(std::string("converge --resolutions 20,40 ") + file);
        EXPECT_EQ(o.code, 0) << o.out;
        EXPECT_EQ(o.lines(), 3u);
    }
    EXPECT_EQ(whorl("compare plume --set resolution=16 --lanes p.png --at 1 --csv -").code, 2)
        << "it has no lanes";
}

/// What section 5.4 of the thesis says of its figure 5.21, by the effective viscosity of the velocity's
/// advection, meant over each 120 steps.
TEST_F(CommandLine, ComparesThePlumesAsTheThesisDoes) {
    const Outcome o =
        whorl("compare plume --set resolution=40 --lanes thesis-five --out sheet.png --csv sheet.csv");
    ASSERT_EQ(o.code, 0) << o.out;
    EXPECT_GT(read_png(folder / "sheet.png").width, 1500);
    std::istringstream table(contents("sheet.csv"));
    std::string line;
    std::getline(table, line);
    EXPECT_TRUE(line.ends_with(",effective_viscosity"));
    std::map<int, std::vector<std::pair<double, std::string>>> by_step;
    while (std::getline(table, line)) {
        const std::string name = line.substr(0, line.find(','));
        const int step = std::stoi(line.substr(name.size() + 1));
        by_step[step].emplace_back(std::stod(line.substr(line.rfind(',') + 1)), name);
    }
    ASSERT_EQ(by_step.size(), 5u);
    for (auto& [step, lanes] : by_step) {
        std::sort(lanes.rbegin(), lanes.rend());
        std::vector<std::string> order;
        for (const auto& lane : lanes) order.push_back(lane.second);
        // SL-LIN loses most, MacCormack least, and ASLAM stands beside SL-FC.
        EXPECT_EQ(order, (std::vector<std::string>{"SL-LIN", "ASLAM", "SL-FC", "MC-LIN", "MC-FC"})) << step;
    }
}

TEST_F(CommandLine, ComparesWithAFinerReference) {
    write("truth.toml",
          "whorl = 1\nreference = 2\n[[lane]]\nname = \"SL\"\n[[lane]]\nname = \"MC\"\n"
          "set = [\"advector=maccormack\"]\n[[lane]]\nname = \"truth\"\nrefine = 4\n"
          "set = [\"advector=maccormack\"]\n");
    const Outcome o = whorl(
        "compare shear-layer --set resolution=24 --set advector=semi-lagrangian --lanes truth.toml "
        "--at 240 --csv t.csv");
    ASSERT_EQ(o.code, 0) << o.out;
    const std::string table = contents("t.csv");
    const auto l2 = [&](const std::string& lane) {
        std::string row = table.substr(table.find("\n" + lane + ",") + 1);
        for (int k = 0; k < 9; ++k) row = row.substr(row.find(',') + 1);
        return row.substr(0, row.find(','));
    };
    EXPECT_EQ(l2("truth"), "");
    EXPECT_LT(std::stod(l2("MC")), std::stod(l2("SL")));
}

TEST_F(CommandLine, FilmsInNumberedPictures) {
    fs::create_directory(folder / "f");
    const Outcome o = whorl(
        "run plume --lanes aslam-weights --set resolution=16 --steps 10 --animate f/%03d.png --every 5");
    ASSERT_EQ(o.code, 0) << o.out;
    EXPECT_TRUE(fs::exists(folder / "f/003.png"));
    EXPECT_FALSE(fs::exists(folder / "f/004.png"));
    EXPECT_NE(whorl("run plume --steps 5 --animate nowhere/%03d.png").code, 0);
    EXPECT_NE(whorl("run plume --steps 5 --animate a.avi").code, 0);
}

TEST_F(CommandLine, RefusesRunsThatAreNone) {
    expect_refused(whorl("compare plume"), "--out");
    expect_refused(whorl("compare plume --lanes thesis --out a.png"), "did you mean thesis-five");
    expect_refused(whorl("compare plume --at 9,3 --out a.png"), "rise");
    expect_refused(whorl("compare plume --out a.jpg"), "PNG");
    expect_refused(whorl("run plume --save a.txt"), ".toml");
    write("not.png", "GIF89a");
    expect_refused(whorl("run not.png"), "not.png");
    ASSERT_EQ(whorl("run plume --set resolution=16 --steps 2 --picture p.png").code, 0);
    const std::string whole = contents("p.png");
    write("cut.png", whole.substr(0, whole.size() / 2));
    expect_refused(whorl("run cut.png"), "cut.png");
    std::string flipped = whole;
    flipped[whole.find("Whorl run") + 30] ^= 1;
    write("flipped.png", flipped);
    expect_refused(whorl("run flipped.png"), "flipped.png");
    write_png(folder / "foreign.png", Image{2, 2, std::vector<std::uint8_t>(16)});
    expect_refused(whorl("run foreign.png"), "carries no run");
    write("lanes.toml", "whorl = 1\n[[lane]]\nrefine = 8\n");
    expect_refused(whorl("run plume --set resolution=512 --lanes lanes.toml"), "more than 2048");
    write("late.toml",
          "whorl = 1\nexperiment = \"plume\"\nresolution = 16\nadvector = \"aslam\"\n"
          "commands = \"\"\"\n3 set interpolation=bicubic\n\"\"\"\n");
    expect_refused(whorl("run late.toml --steps 9"), "step 3: aslam takes");
}

}  // namespace
}  // namespace whorl
