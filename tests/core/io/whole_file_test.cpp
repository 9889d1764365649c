// Files appear whole or not at all, whatever fails.
#include "core/io/whole_file.h"

#include "core/io/series.h"
#include "tests/support/full_disk.h"
#include "tests/support/own_directory.h"

namespace whorl {
namespace {

namespace fs = std::filesystem;
using test::on_full_disk;

class Whole : public test::OwnDirectory {
  protected:
    void SetUp() override {
        OwnDirectory::SetUp();
        file_ = directory_ / "file";
    }
    fs::path file_;
};

TEST_F(Whole, AppearsWhenItIsFinished) {
    WholeFile file(file_);
    file.write("one ");
    EXPECT_FALSE(fs::exists(file_));
    file.write("two");
    file.finish();
    EXPECT_EQ(contents(file_), "one two");
    EXPECT_EQ(files(), 1u);
}

TEST_F(Whole, TakesItsPermissionsFromTheProcess) {
    put(directory_ / "usual", "");
    write_whole_file(file_, "");
    EXPECT_EQ(fs::status(file_).permissions(), fs::status(directory_ / "usual").permissions());
}

TEST_F(Whole, LeavesTheOldFileUntilThen) {
    put(file_, "old");
    {
        WholeFile file(file_);
        file.write("new");
        EXPECT_EQ(contents(file_), "old");
    }
    EXPECT_EQ(contents(file_), "old") << "never finished";
    EXPECT_EQ(files(), 1u);
    write_whole_file(file_, "new");
    EXPECT_EQ(contents(file_), "new");
}

TEST_F(Whole, TwoOfOneNameDoNotMix) {
    WholeFile one(file_);
    WholeFile two(file_);
    one.write("one");
    two.write("two");
    one.finish();
    two.finish();
    EXPECT_EQ(contents(file_), "two");
    EXPECT_EQ(files(), 1u);
}

TEST_F(Whole, SaysWhatIsInTheWay) {
    const auto reason = [](const fs::path& path) { return complaint([&] { write_whole_file(path, "x"); }); };
    const std::string gone = directory_ / "none";
    EXPECT_EQ(reason(gone + "/a"), "cannot write " + gone + "/a: there is no directory " + gone);
    EXPECT_EQ(reason(directory_), "cannot write " + directory_.string() + ": this is a directory");
    EXPECT_EQ(reason(""), "cannot write : this names no file");
    EXPECT_EQ(reason("/dev/full"), "cannot write /dev/full: this is no file");
    EXPECT_EQ(reason(directory_ / std::string(300, 'n')),
              "cannot write " + (directory_ / std::string(300, 'n')).string() + ": File name too long");
    put(file_, "");
    EXPECT_EQ(reason(file_ / "a"), "cannot write " + (file_ / "a").string() + ": Not a directory");
    EXPECT_EQ(files(), 1u);
}

TEST_F(Whole, NeedsPermission) {
    if (::geteuid() == 0) {  // root may write anywhere but into /proc
        EXPECT_TRUE(
            complaint([] { write_whole_file("/proc/a", "x"); }).starts_with("cannot write /proc/a: "));
        return;
    }
    fs::permissions(directory_, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(complaint([&] { write_whole_file(file_, "x"); }),
              "cannot write " + file_.string() + ": Permission denied");
    fs::permissions(directory_, fs::perms::owner_all);
}

TEST_F(Whole, DirectoryMayVanish) {
    const fs::path inner = directory_ / "inner";
    fs::create_directory(inner);
    WholeFile file(inner / "a");
    file.write("x");
    fs::remove_all(inner);
    EXPECT_EQ(complaint([&] { file.finish(); }),
              "cannot write " + (inner / "a").string() + ": there is no directory " + inner.string());
    EXPECT_EQ(files(), 0u);
}

TEST_F(Whole, DirectoryMayTakeTheName) {
    WholeFile file(file_);
    fs::create_directory(file_);
    EXPECT_EQ(complaint([&] { file.finish(); }), "cannot write " + file_.string() + ": this is a directory");
}

TEST_F(Whole, DiskMayBeFull) {
    put(file_, "old");
    for (const rlim_t room : {0u, 1u, 4096u, 99'999u}) {
        const std::string message =
            on_full_disk(room, [&] { write_whole_file(file_, std::string(100'000, 'x')); });
        EXPECT_EQ(message, "cannot write " + file_.string() + ": File too large") << room;
        EXPECT_EQ(contents(file_), "old");
        EXPECT_EQ(files(), 1u);
    }
}

TEST_F(Whole, SeriesOnAFullDiskIsNoSeries) {
    const auto write_rows = [&] {
        Series series(file_, "a,b");
        for (int k = 0; k < 10'000; ++k) {
            const double row[] = {k / 3.0, 1e-9 * k};
            series.row(row);
        }
        series.finish();
    };
    EXPECT_EQ(on_full_disk(5000, write_rows), "cannot write " + file_.string() + ": File too large");
    EXPECT_EQ(files(), 0u);
    write_rows();
    EXPECT_TRUE(contents(file_).starts_with("a,b\n0,0\n0.333333333,1e-09\n"));
}

TEST_F(Whole, CheckLeavesNothing) {
    check_writable(file_);
    EXPECT_EQ(files(), 0u);
    EXPECT_TRUE(on_full_disk(0, [&] {
                    check_writable(file_);
                }).empty());  // an empty file fits: only writing will tell
    put(file_, "precious");
    check_writable(file_);
    EXPECT_EQ(contents(file_), "precious");
    EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace whorl
