// Films: with ffmpeg, with one that fails, and without.
#include "app/film/film.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <random>

#include "app/film/child.h"
#include "tests/support/full_disk.h"
#include "tests/support/own_directory.h"

namespace whorl::app {
namespace {

namespace fs = std::filesystem;

/// A picture of two colours, left and right, that `k` shifts.
Image picture(int k, int width = 64, int height = 48) {
    Image image{width, height, {}};
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const bool left = i < width / 2 + k;
            for (const int c : {left ? 220 : 20, left ? 120 : 60, left ? 40 : 200, 255})
                image.rgba.push_back(static_cast<std::uint8_t>(c));
        }
    }
    return image;
}

/// Puts things in PATH for as long as it lives.
class Path {
  public:
    explicit Path(const std::string& path) : old_(std::getenv("PATH")) { ::setenv("PATH", path.c_str(), 1); }
    ~Path() { ::setenv("PATH", old_.c_str(), 1); }
    Path(const Path&) = delete;
    Path& operator=(const Path&) = delete;

  private:
    std::string old_;
};

class FilmTest : public test::OwnDirectory {
  protected:
    /// Makes this shell script be the ffmpeg that is found. It lists the encoder of the real one.
    void use_ffmpeg(const std::string& script) {
        const fs::path bin = directory_ / "bin";
        fs::create_directory(bin);
        put(bin / "ffmpeg",
            "#!/bin/sh\ncase \"$*\" in *-encoders*) echo ' V....D libx264  '; exit 0;; esac\n"
            "for last; do :; done\nout=${last#file:}\n" +
                script + "\n");
        fs::permissions(bin / "ffmpeg", fs::perms::owner_all);
        path_.emplace(bin.string() + ":/usr/bin:/bin");
    }
    std::string film(const std::string& name) const { return directory_ / name; }
    /// What is in the directory besides the script.
    std::vector<std::string> made() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(directory_)) {
            if (entry.path().filename() != "bin") names.push_back(entry.path().filename());
        }
        std::sort(names.begin(), names.end());
        return names;
    }
    static std::string make(const fs::path& path, int frames = 5) {
        return complaint([&] {
            Film film(path, 25);
            for (int k = 0; k < frames; ++k) film.add(picture(k));
            film.finish();
        });
    }

    std::optional<Path> path_;
};

using Names = std::vector<std::string>;

// ---- numbered pictures

TEST_F(FilmTest, NumberedPicturesCountFromOne) {
    const Path nothing("");
    EXPECT_EQ(make(film("a-%03d.png"), 3), "");
    EXPECT_EQ(made(), (Names{"a-001.png", "a-002.png", "a-003.png"}));
    EXPECT_EQ(read_png(film("a-002.png")), picture(1));
}

TEST_F(FilmTest, NumberedPicturesStayWhenBrokenOff) {
    {
        Film film(directory_ / "%d.png", 25);
        film.add(picture(0));
    }
    EXPECT_EQ(made(), Names{"1.png"});
}

TEST_F(FilmTest, NumberedPicturesOnAFullDisk) {
    EXPECT_EQ(test::on_full_disk(50,
                                 [&] {
                                     Film film(directory_ / "%d.png", 25);
                                     film.add(picture(0));
                                 }),
              "cannot write " + film("1.png") + ": File too large");
    EXPECT_EQ(made(), Names{});
}

TEST_F(FilmTest, DirectoryMayVanish) {
    fs::create_directory(directory_ / "frames");
    Film film(directory_ / "frames/%04d.png", 25);
    film.add(picture(0));
    fs::remove_all(directory_ / "frames");
    EXPECT_NE(complaint([&] { film.add(picture(1)); }).find("there is no directory"), std::string::npos);
}

// ---- what is known before a long run

TEST_F(FilmTest, NamesThatAreNone) {
    for (const std::string name : {"film", "film.avi", "film.png", "%s.png", "%d%d.png", "%04d.jpg",
                                   "%00d.png", "%04d", "%.png", "%12d.png"}) {
        EXPECT_EQ(make(film(name)),
                  "cannot write " + film(name) +
                      ": a film is NAME.mp4, NAME.gif, or numbered pictures such as frames/%04d.png");
    }
    EXPECT_NE(make(film("%d/picture.png")).find("a film is"), std::string::npos)
        << "the number is in the name";
    EXPECT_NE(make(film("none/%d.png")).find("there is no directory"), std::string::npos);
    EXPECT_NE(make(film("none/a.mp4")).find("cannot write"), std::string::npos);
    for (const int rate : {0, -1, 241}) {
        EXPECT_NE(complaint([&] { Film film(directory_ / "%d.png", rate); }).find("1 to 240"),
                  std::string::npos);
    }
    EXPECT_EQ(made(), Names{});
}

TEST_F(FilmTest, SaysThatFfmpegIsMissing) {
    const Path nothing(directory_);
    for (const std::string name : {"a.mp4", "a.gif", "A.GIF"}) {
        EXPECT_EQ(complaint([&] { Film film(directory_ / name, 25); }),
                  "cannot write " + film(name) +
                      ": ffmpeg is not installed: it writes MP4 and GIF; numbered PNGs need nothing: "
                      "frames/%04d.png");
    }
    EXPECT_EQ(made(), Names{});
}

TEST_F(FilmTest, FfmpegWithoutAnEncoder) {
    use_ffmpeg("exit 1");
    put(directory_ / "bin/ffmpeg", "#!/bin/sh\necho ' V..... rawvideo '");
    EXPECT_EQ(complaint([&] { Film film(directory_ / "a.mp4", 25); }),
              "cannot write " + film("a.mp4") +
                  ": this ffmpeg has no encoder for it (libx264, libopenh264, mpeg4)");
    put(directory_ / "bin/ffmpeg", "#!/bin/sh\necho 'libfoo.so.7: cannot open' >&2; exit 127");
    EXPECT_EQ(complaint([&] { Film film(directory_ / "a.gif", 25); }),
              "cannot write " + film("a.gif") + ": ffmpeg: libfoo.so.7: cannot open");
    EXPECT_EQ(made(), Names{});
}

// ---- an ffmpeg that fails

TEST_F(FilmTest, FfmpegGetsEveryPixel) {
    use_ffmpeg("cat > \"$out\"");
    EXPECT_EQ(make(film("a.mp4"), 3), "");
    EXPECT_EQ(contents(film("a.mp4")).size(), 3u * 64 * 48 * 4);
    EXPECT_EQ(made(), Names{"a.mp4"});
}

TEST_F(FilmTest, OddSizesArePaddedWithTheirEdge) {
    use_ffmpeg("cat > \"$out\"");
    Film film(directory_ / "a.mp4", 25);
    film.add(picture(0, 5, 3));
    film.finish();
    const std::string bytes = contents(directory_ / "a.mp4");
    ASSERT_EQ(bytes.size(), 6u * 4 * 4);
    const auto pixel = [&](int i, int j) { return bytes.substr(4 * (6 * j + i), 4); };
    for (int j = 0; j < 4; ++j) EXPECT_EQ(pixel(5, j), pixel(4, j));
    for (int i = 0; i < 6; ++i) EXPECT_EQ(pixel(i, 3), pixel(i, 2));
}

TEST_F(FilmTest, FfmpegDies) {
    for (const auto& [script, reason] :
         {std::pair{"echo 'first' >&2; echo 'it hurts' >&2; exit 3", "it hurts"},
          {"exit 3", "it ended with code 3 and no word why"},
          {"kill -9 $$", "it was stopped: Killed"},
          {"head -c 20000 > \"$out\"; echo 'no more' >&2; exit 1", "no more"},
          {"cat > \"$out\"; echo 'trailer' >&2; exit 1", "trailer"},
          {"cat > /dev/null", "wrote nothing"}}) {
        put(directory_ / "a.mp4", "old");
        use_ffmpeg(script);
        const std::string message = make(film("a.mp4"), 200);
        EXPECT_TRUE(message.starts_with("cannot write " + film("a.mp4") + ": ffmpeg")) << message;
        EXPECT_TRUE(message.ends_with(reason)) << message;
        EXPECT_EQ(made(), Names{"a.mp4"});
        EXPECT_EQ(contents(film("a.mp4")), "old");
    }
}

TEST_F(FilmTest, FfmpegTakesTheFileAway) {
    use_ffmpeg("cat > /dev/null; rm \"$out\"");
    EXPECT_NE(make(film("a.mp4")), "");
    EXPECT_EQ(made(), Names{});
}

TEST_F(FilmTest, BrokenOffLeavesNothing) {
    use_ffmpeg("cat > \"$out\"; sleep 600");
    {
        Film film(directory_ / "a.mp4", 25);
        film.add(picture(0));
    }
    EXPECT_EQ(made(), Names{});
    { const Film film(directory_ / "a.gif.mp4", 25); }
    EXPECT_EQ(made(), Names{});
}

TEST_F(FilmTest, RefusesMixedSizesAndEmptyFilms) {
    use_ffmpeg("cat > \"$out\"");
    EXPECT_EQ(make(film("a.mp4"), 0), "cannot write " + film("a.mp4") + ": a film without a picture is none");
    EXPECT_EQ(complaint([&] {
                  Film film(directory_ / "a.mp4", 25);
                  film.add(picture(0));
                  film.add(picture(0, 32, 48));
              }),
              "cannot write " + film("a.mp4") + ": its pictures are 64 × 48 pixels, and one is 32 × 48");
    EXPECT_EQ(made(), Names{});
}

// ---- the real one

class RealFfmpeg : public FilmTest {
  protected:
    void SetUp() override {
        FilmTest::SetUp();
        if (find_program("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    }
    /// The pictures of a film, as ffmpeg reads them.
    std::vector<Image> frames(const std::string& name) const {
        const fs::path folder = directory_ / "frames";
        fs::create_directory(folder);
        Child child({find_program("ffmpeg"), "-loglevel", "error", "-i", film(name), "-vsync", "passthrough",
                     folder / "%03d.png"});
        EXPECT_TRUE(child.wait()) << child.reason();
        std::vector<Image> images;
        for (int k = 1;; ++k) {
            char file[16];
            std::snprintf(file, sizeof file, "%03d.png", k);
            if (!fs::exists(folder / file)) break;
            images.push_back(read_png(folder / file));
        }
        fs::remove_all(folder);
        return images;
    }
    static int difference(const Image& a, const Image& b, int i, int j) {
        int most = 0;
        for (int c = 0; c < 3; ++c) {
            most = std::max(most,
                            std::abs(a.rgba[4 * (j * a.width + i) + c] - b.rgba[4 * (j * b.width + i) + c]));
        }
        return most;
    }
};

/// Of 255: two roundings, to YUV in 8 bits and back, and the encoder's own error at its quality.
constexpr int video_tolerance = 6;
/// A palette holds the two colours; the dither spreads what rounding leaves.
constexpr int gif_tolerance = 4;

TEST_F(RealFfmpeg, WritesMp4OfAnySize) {
    for (const auto& [width, height] : {std::pair{64, 48}, {63, 47}}) {
        // A colon and a dash would be a protocol and an option.
        const std::string name = "-a:b.mp4";
        {
            Film film(directory_ / name, 25);
            for (int k = 0; k < 10; ++k) film.add(picture(k, width, height));
            film.finish();
        }
        EXPECT_EQ(made(), Names{name});
        const std::vector<Image> back = frames(name);
        ASSERT_EQ(back.size(), 10u);
        EXPECT_EQ(back[0].width, 64);
        EXPECT_EQ(back[0].height, 48);
        for (const int i : {5, 60})
            EXPECT_LE(difference(back[3], picture(3, 64, 48), i, 20), video_tolerance);
    }
}

TEST_F(RealFfmpeg, WritesGif) {
    EXPECT_EQ(make(film("a.gif"), 10), "");
    EXPECT_EQ(made(), Names{"a.gif"});
    const std::vector<Image> back = frames("a.gif");
    ASSERT_EQ(back.size(), 10u);
    for (const int i : {5, 60}) EXPECT_LE(difference(back[3], picture(3), i, 20), gif_tolerance);
}

TEST_F(RealFfmpeg, GifLeavesOutWhatItCannotShow) {
    {
        Film film(directory_ / "a.gif", 100);
        for (int k = 0; k < 20; ++k) film.add(picture(k));
        film.finish();
    }
    EXPECT_NEAR(static_cast<double>(frames("a.gif").size()), 10, 1);  // a frame more or less at the ends
}

TEST_F(RealFfmpeg, OnAFullDiskIsNoFilm) {
    constexpr rlim_t room = 4096;  // for what ffmpeg says, too: less than the film, more than a few lines
    Image noise = picture(0);
    std::minstd_rand random(1);
    for (const char* name : {"a.mp4", "a.gif"}) {
        const std::string message = test::on_full_disk(RLIM_INFINITY, [&] {
            Film film(directory_ / name, 25);
            test::fill_disk(room);
            for (int k = 0; k < 30; ++k) {
                for (std::uint8_t& value : noise.rgba) value = static_cast<std::uint8_t>(random() >> 8);
                film.add(noise);
            }
            film.finish();
        });
        EXPECT_TRUE(message.starts_with("cannot write " + film(name) + ": ffmpeg: ")) << message;
        EXPECT_TRUE(message.ends_with("File too large")) << message;
        EXPECT_EQ(made(), Names{});
    }
}

TEST_F(RealFfmpeg, DirectoryMayVanish) {
    fs::create_directory(directory_ / "inner");
    Film film(directory_ / "inner/a.mp4", 25);
    film.add(picture(0));
    fs::remove_all(directory_ / "inner");
    EXPECT_NE(complaint([&] {
                  film.add(picture(1));
                  film.finish();
              }),
              "");
    EXPECT_EQ(made(), Names{});
}

}  // namespace
}  // namespace whorl::app
