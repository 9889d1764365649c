// Animations by another program: finished, failed, cancelled; never anything half-written.
#include "app/window/film_maker.h"

#include <gtest/gtest.h>

#include <optional>

#include "tests/support/eventually.h"
#include "tests/support/own_directory.h"

namespace whorl::app {
namespace {

namespace fs = std::filesystem;

class FilmMaking : public test::OwnDirectory {
  protected:
    void SetUp() override {
        OwnDirectory::SetUp();
        before_ = fs::current_path();
        here_ = directory_ / "here";
        fs::create_directory(here_);
        fs::current_path(here_);
    }
    void TearDown() override {
        fs::current_path(before_);
        OwnDirectory::TearDown();
    }
    /// A program that does this instead of making a film; its arguments are those of `whorl`.
    fs::path program(const std::string& does) {
        const fs::path path = directory_ / "program";
        put(path, "#!/bin/sh\n" + does + "\n");
        fs::permissions(path, fs::perms::owner_all);
        return path;
    }
    static FilmMaker::Outcome outcome_of(FilmMaker& maker) {
        std::optional<FilmMaker::Outcome> outcome;
        if (eventually([&] { return (outcome = maker.take_outcome()).has_value(); })) return *outcome;
        return {"", "nothing came of it", false};
    }
    std::size_t left() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(here_), {}));
    }

    static constexpr FilmOptions pictures{.kind = FilmOptions::Kind::Pictures, .every = 3};
    fs::path before_, here_;
};

TEST_F(FilmMaking, AFilmAppearsWhenItIsComplete) {
    // run FILE --animate OUT --every N --fps F
    FilmMaker maker(
        program("test \"$1\" = run && test -s \"$2\" && test \"$6\" = 3 || exit 1\n"
                "echo picture > \"$(dirname \"$4\")/0001.png\""));
    maker.start({}, pictures, 0);
    EXPECT_TRUE(maker.progress(1.5).has_value());
    const FilmMaker::Outcome outcome = outcome_of(maker);
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(fs::path(outcome.path).filename(), "whorl-0001-frames");
    EXPECT_EQ(contents(here_ / "whorl-0001-frames" / "0001.png"), "picture\n");
    EXPECT_EQ(left(), 1u) << "and nothing else";
    EXPECT_FALSE(maker.busy());
    maker.start({}, pictures, 0);
    EXPECT_EQ(fs::path(outcome_of(maker).path).filename(), "whorl-0002-frames");
}

TEST_F(FilmMaking, AFailureGivesItsReasonAndLeavesNothing) {
    FilmMaker maker(program("echo half > \"$(dirname \"$4\")/0001.png\"; echo 'no more disk' >&2; exit 1"));
    maker.start({}, pictures, 0);
    EXPECT_EQ(outcome_of(maker).error, "no more disk");
    EXPECT_EQ(left(), 0u);
}

TEST_F(FilmMaking, WhatIsCancelledLeavesNothing) {
    FilmMaker maker(program("echo half > \"$(dirname \"$4\")/0001.png\"; exec sleep 1000"));
    maker.start({}, pictures, 0);
    ASSERT_TRUE(eventually([&] { return left() > 0; }));
    maker.cancel();
    EXPECT_TRUE(outcome_of(maker).cancelled);
    EXPECT_EQ(left(), 0u);
}

TEST_F(FilmMaking, ClosingTheWindowLeavesNothing) {
    {
        FilmMaker maker(program("exec sleep 1000"));
        maker.start({}, pictures, 0);
        ASSERT_TRUE(eventually([&] { return left() > 0; }));
    }
    EXPECT_EQ(left(), 0u);
}

TEST_F(FilmMaking, AFolderThatHasGoneIsSaid) {
    fs::remove_all(here_);
    FilmMaker maker(program("exit 0"));
    maker.start({}, pictures, 0);
    EXPECT_EQ(outcome_of(maker).error, "the current folder has gone");
}

}  // namespace
}  // namespace whorl::app
