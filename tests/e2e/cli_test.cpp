// The command line as a person types it: what it prints, writes, refuses and returns.
#include "core/io/png.h"
#include "tests/support/command_line.h"

namespace whorl {
namespace {

TEST_F(CommandLine, RunsAPresetAndWritesARowAStep) {
    const Outcome o = whorl("run plume --steps 5 --set resolution=32 --csv -");
    EXPECT_EQ(o.code, 0);
    EXPECT_EQ(o.lines(), 6u) << o.out;
    EXPECT_TRUE(o.out.starts_with(
        "step,time,density_percent,kinetic_energy,enstrophy,max_divergence,min,max,L1,L2,Linf\n1,0.01666"))
        << o.out;
}

TEST_F(CommandLine, PicksTheColumnsOfATable) {
    const Outcome run =
        whorl("run plume --steps 1 --set resolution=16 --csv - --measures max,limited_velocity,l1");
    EXPECT_EQ(run.code, 0);
    EXPECT_TRUE(run.out.starts_with("step,time,max,limited_velocity,L1\n1,0.0166666667,0.5,10,\n"))
        << run.out;
    EXPECT_TRUE(whorl("experiment rest --at 1 --measures cfl").out.starts_with("step,time,cfl\n1,"));
    EXPECT_TRUE(whorl("compare plume --at 1 --set resolution=16 --csv - --measures enstrophy")
                    .out.starts_with("lane,step,time,enstrophy\nSL-LIN,1,"));
    expect_refused(whorl("run plume --steps 1 --csv - --measures enstrohpy"),
                   "unknown measure \"enstrohpy\"; did you mean enstrophy?");
    expect_refused(whorl("run plume --steps 1 --measures min"), "give --csv FILE too");
}

TEST_F(CommandLine, SaysSoWhereThereIsNoSmoke) {
    const Outcome o = whorl("run empty --steps 2 --set resolution=16");
    EXPECT_EQ(o.code, 0);
    EXPECT_NE(o.out.find("no smoke"), std::string::npos) << o.out;
}

TEST_F(CommandLine, WritesSeriesTimingAndPicture) {
    const Outcome o =
        whorl("run plume-obstacle --steps 20 --set resolution=32 --csv a.csv --timing t.csv --picture p.png");
    ASSERT_EQ(o.code, 0) << o.out;
    EXPECT_TRUE(contents("a.csv").starts_with("step,"));
    EXPECT_TRUE(contents("t.csv").starts_with("phase,median_ms\nforces,"));
    EXPECT_NE(contents("t.csv").find("\ntotal,"), std::string::npos);
    const Image image = read_png(folder / "p.png");
    EXPECT_GT(image.width, 600);
    EXPECT_EQ(files(), 3u) << "nothing else is left behind";
}

TEST_F(CommandLine, DrawsEveryView) {
    for (const char* view : {"density", "temperature", "speed", "vorticity", "pressure", "divergence"}) {
        const Outcome o =
            whorl(std::string("run plume --steps 3 --set resolution=16 --picture v.png --view ") + view);
        EXPECT_EQ(o.code, 0) << o.out;
    }
    EXPECT_EQ(whorl("experiment rest --set resolution=20 --at 3 --picture v.png --view difference").code, 0);
    expect_refused(whorl("run plume --steps 1 --picture v.png --view exact"), "no exact to show");
    EXPECT_EQ(
        whorl("run plume --lanes tracers --steps 3 --set resolution=16 --picture v.png --difference").code,
        0);
}

TEST_F(CommandLine, SameRowsForAnyThreadCount) {
    const Outcome one = whorl("run plume --steps 30 --csv - --threads 1");
    EXPECT_EQ(one.out, whorl("run plume --steps 30 --csv - --threads 2").out);
}

TEST_F(CommandLine, MeasuresAnExperimentAtItsSteps) {
    const Outcome o = whorl("experiment translation-1d --set advector=maccormack --at 1,60");
    EXPECT_EQ(o.code, 0);
    EXPECT_EQ(o.lines(), 3u) << o.out;
    EXPECT_TRUE(o.out.starts_with("step,time,L1,L2,Linf,density_percent,min,max\n1,"));
    // No exact solution, no error.
    EXPECT_NE(whorl("experiment rotation --at 30").out.find("30,0.5,,,,"), std::string::npos);
}

TEST_F(CommandLine, ExplainsAValue) {
    const Outcome o = whorl("explain plume --at 30 --cell 16,2 --set resolution=32 --set advector=aslam");
    EXPECT_EQ(o.code, 0) << o.out;
    for (const char* words : {"Density at (16, 2): ", "back along the flow: (20.625, 3.125) → (",
                              "25 particles", "x_s (+0.5, -0.25)", "in length units",
                              "x_s from the node, in cells", "thesis alg. 4.1, eq. 4.1–4.3",
                              "thesis eq. 4.1, its bracket", "limiter: Clamp", "limiters acted at "}) {
        EXPECT_NE(o.out.find(words), std::string::npos) << words << "\n" << o.out;
    }
    const Outcome lanes =
        whorl("explain plume --at 3 --cell 32,2 --field u --set resolution=32 --lanes tracers");
    EXPECT_EQ(lanes.code, 0) << lanes.out;
    EXPECT_NE(lanes.out.find("on a wall: no velocity across"), std::string::npos) << lanes.out;
    expect_refused(whorl("explain plume --at 3 --cell 16"), "--cell takes two numbers");
    expect_refused(whorl("explain plume --at 3 --cell 500,2"), "(500, 2) is no node of density");
    expect_refused(whorl("explain plume --at 0 --cell 5,2"), "\"0\" is not a whole number from 1 to");
    expect_refused(whorl("explain plume --at 3 --cell 5,2 --field densty"), "did you mean density");
    expect_refused(whorl("explain rotation --at 3 --cell 5,2 --field u"), "the flow is prescribed");
}

TEST_F(CommandLine, Converges) {
    const Outcome o = whorl("converge translation --set steps=30 --resolutions 20,40");
    EXPECT_EQ(o.code, 0);
    EXPECT_EQ(o.lines(), 3u) << o.out;
    expect_refused(whorl("converge plume --resolutions 20,40"), "no exact solution");
    expect_refused(whorl("converge rotation --resolutions 40,70"), "70 is not a multiple of 40");
    expect_refused(whorl("converge rotation --resolutions 40"), "two or more");
    expect_refused(whorl("converge rotation --set steps=7 --resolutions 20,40"),
                   "not known at step 7; it is known every 10 units of time");
}

TEST_F(CommandLine, ListsEverything) {
    const Outcome o = whorl("list");
    EXPECT_EQ(o.code, 0);
    for (const char* word : {"presets", "aslam-bilinear", "fritsch-carlson-square", "rk3", "jittered",
                             "gaussian", "revert", "taylor-green", "confinement", "viridis"}) {
        EXPECT_NE(o.out.find(word), std::string::npos) << word;
    }
    EXPECT_EQ(whorl("list tracers").lines(), 4u);
    expect_refused(whorl("list tracer"), "did you mean tracers");
    EXPECT_EQ(whorl("--version").code, 0);
    EXPECT_EQ(whorl("--help").code, 0);
    EXPECT_EQ(whorl("run --help").code, 0);
}

TEST_F(CommandLine, RefusesBadInputInOneLine) {
    expect_refused(whorl("run plum"), "did you mean plume");
    expect_refused(whorl("run plume --set advectr=aslam"), "did you mean advector");
    expect_refused(whorl("run plume --set advector=mccormack"), "did you mean maccormack");
    expect_refused(whorl("run plume --set zeta=9"), "out of range: 0 to 4");
    expect_refused(whorl("run plume --set advector=aslam --set interpolation=b-spline"), "linear weights");
    expect_refused(whorl("run plume --steps many"),
                   "--steps: \"many\" is not a whole number from 0 to 10000000");
    expect_refused(whorl("run plume --steps -4"), "--steps: \"-4\" is not");
    expect_refused(whorl("run plume --steps 1e3"), "--steps: \"1e3\" is not");
    expect_refused(whorl("run plume --steps"), "--steps lacks its value; see whorl run --help");
    expect_refused(whorl("run plume --steps 3 --steps 4"), "--steps is given more than once");
    expect_refused(whorl("run plume --scale big"), "--scale: \"big\" is not a number from 0.5 to 8");
    expect_refused(whorl("run plume --stepz 3 --foo"), "unknown option --stepz; did you mean --steps?");
    expect_refused(whorl("--steps 1 run plume"), "--steps stands before run");
    expect_refused(whorl("rnu plume"), "unknown verb \"rnu\"; did you mean run?");
    expect_refused(whorl("run plume --csv ''"), "--csv: it lacks its value");
    expect_refused(whorl("run plume --csv a --timing a"), "--csv and --timing name the same file, a");
    expect_refused(whorl("run plume --light"), "give --picture FILE.png too");
    expect_refused(whorl("run plume --animate x.avi"), "a film is NAME.mp4, NAME.gif");
    for (const char* size : {"0x0", "65535x65535", "10x10", "800x", "800x600x", "-800x600"})
        expect_refused(whorl(std::string("--size=") + size), "give WIDTHxHEIGHT from 320x240 to 8192x8192");
    EXPECT_EQ(whorl("list >/dev/full").code, 1);
    expect_refused(whorl("run plume one two"), "\"one\" is one argument too many");
    expect_refused(whorl("--set zeta=1 run plume"), "--set stands before run");
    expect_refused(whorl("run xyz"), "give plume, plume-obstacle,");
    expect_refused(whorl("run"), "scene is required; see whorl run --help");
    expect_refused(whorl("run plume --steps 1 --picture p.png --map viridid"), "did you mean viridis");
    expect_refused(whorl("run plume --steps 1 --picture p.png --view dens"), "did you mean density");
    expect_refused(whorl("run plume --steps 1 --picture p.png --range 3,1"), "rising");
    expect_refused(whorl("experiment rotaton"), "did you mean rotation");
    expect_refused(whorl("experiment rotation --at 3,x"), "3,x");
    expect_refused(whorl("run missing.toml"), "missing.toml");
    write("lesson.toml", "whorl = 1\ntitle = \"x\"\n[[step]]\n");
    expect_refused(whorl("run lesson.toml"), "lesson.toml: this is a lesson; `whorl lesson lesson.toml`");
    expect_refused(whorl("lesson.toml"), "lesson.toml:3:1: ");
    std::filesystem::remove(folder / "lesson.toml");
    expect_refused(whorl("run plume --steps 1 --picture p.jpg"), "PNG");
    expect_refused(whorl("run plume --steps 1 --view speed"), "--picture");
    expect_refused(whorl("experiment rotation --at 3 --steps 5"), "--at and --steps");
    expect_refused(whorl("converge rotation --set resolution=40"), "--resolutions");
    EXPECT_EQ(files(), 0u);
}

TEST_F(CommandLine, NamesThePlaceInABrokenScene) {
    write("a.toml", "whorl = 1\nexperiment = \"plume\"\nresolution = 24\n");
    EXPECT_EQ(whorl("run a.toml --steps 2").code, 0);
    write("b.toml", "whorl = 1\nresolution = \n");
    expect_refused(whorl("run b.toml --steps 2"), "b.toml:2:");
    write("c.toml", "whorl = 1\n\nzeta = 12\n");
    expect_refused(whorl("run c.toml --steps 2"), "c.toml:3:8: zeta = 12 is out of range: 0 to 4");
}

TEST_F(CommandLine, FindsOutBeforeTheRunThatItCannotWrite) {
    const Outcome o = whorl("run plume --steps 100000 --csv nowhere/a.csv");
    EXPECT_NE(o.code, 0);
    EXPECT_EQ(o.lines(), 1u) << o.out;
    EXPECT_NE(o.out.find("nowhere"), std::string::npos) << o.out;
    EXPECT_NE(whorl("run plume --steps 100000 --picture nowhere/p.png").code, 0);
}

TEST_F(CommandLine, SaysThatThereIsNoDisplay) {
    const Outcome o = whorl("");
    EXPECT_EQ(o.code, 3) << o.out;
    EXPECT_EQ(o.lines(), 1u) << o.out;
}

}  // namespace
}  // namespace whorl
