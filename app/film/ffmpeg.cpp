#include "app/film/ffmpeg.h"

#include <algorithm>

namespace whorl::app {
namespace {

namespace fs = std::filesystem;

constexpr int max_gif_rate =
    50;  // frames per second: a GIF counts in 1/100 s, and browsers slow 1/100 s down

std::string installed(const fs::path& path) {
    std::string program = find_program("ffmpeg");
    if (program.empty()) {
        cannot_write(path,
                     "ffmpeg is not installed: it writes MP4 and GIF; numbered PNGs need nothing: "
                     "frames/%04d.png");
    }
    return program;
}

/// The options of the best encoder that this ffmpeg has.
std::vector<std::string> encoder_of(const std::string& program, const fs::path& path, Ffmpeg::Format format) {
    struct Encoder {
        const char* name;
        std::vector<std::string> options;
    };
    static const std::vector<Encoder> mp4{
        {"libx264", {"-crf", "18"}}, {"libopenh264", {"-b:v", "8M"}}, {"mpeg4", {"-q:v", "2"}}};
    static const std::vector<Encoder> gif{{"gif", {}}};

    Child child({program, "-hide_banner", "-loglevel", "error", "-encoders"});
    if (!child.wait()) cannot_write(path, "ffmpeg: " + child.reason());
    const std::string listed = child.output();
    std::string names;
    for (const Encoder& encoder : format == Ffmpeg::Format::Mp4 ? mp4 : gif) {
        if (listed.find(std::string(" ") + encoder.name + " ") != listed.npos) {
            std::vector<std::string> options{"-c:v", encoder.name};
            options.insert(options.end(), encoder.options.begin(), encoder.options.end());
            return options;
        }
        names += (names.empty() ? "" : ", ") + std::string(encoder.name);
    }
    cannot_write(path, "this ffmpeg has no encoder for it (" + names + ")");
}

int even(int n) {
    return n + n % 2;
}

}  // namespace

Ffmpeg::Ffmpeg(const fs::path& path, Format format, int frames_per_second)
    : path_(path),
      format_(format),
      frames_per_second_(frames_per_second),
      program_(installed(path)),
      file_(path) {
    encoder_ = encoder_of(program_, path, format);
}

void Ffmpeg::start(int width, int height) {
    // -xerror: without it some ffmpegs say that all is well when the end of the file did not fit on the disk.
    std::vector<std::string> command{program_, "-hide_banner", "-nostats", "-loglevel", "error", "-xerror",
                                     "-y",
                                     // Four bytes a pixel, the fourth without a meaning.
                                     "-f", "rawvideo", "-pixel_format", "rgb0", "-video_size",
                                     std::to_string(width) + "x" + std::to_string(height), "-framerate",
                                     std::to_string(frames_per_second_), "-i", "pipe:0", "-vf"};
    if (format_ == Format::Mp4) {
        // Half the colour's resolution, as players want it; the matrix is named, or they would guess.
        const std::string convert =
            "scale=out_color_matrix=bt709:out_range=limited:flags=accurate_rnd+full_chroma_int,format="
            "yuv420p";
        command.insert(command.end(),
                       {convert, "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc",
                        "iec61966-2-1", "-color_range", "tv", "-movflags", "+faststart", "-f", "mp4"});
    } else {
        // A palette a frame: one for all would hold every frame in memory until the end. The ordered dither
        // stands still from frame to frame.
        const std::string fewer =
            frames_per_second_ > max_gif_rate ? "fps=" + std::to_string(max_gif_rate) + "," : "";
        command.insert(command.end(),
                       {fewer + "split[a][b];[a]palettegen=stats_mode=single:reserve_transparent=0[p];"
                                "[b][p]paletteuse=new=1:dither=bayer:bayer_scale=4",
                        "-f", "gif"});
    }
    command.insert(command.end(), encoder_.begin(), encoder_.end());
    command.push_back("file:" + file_.aside().string());  // whatever the name looks like
    try {
        child_.emplace(command);
    } catch (const std::runtime_error& e) {
        cannot_write(path_, std::string("ffmpeg: ") + e.what());
    }
}

void Ffmpeg::fail() {
    child_->wait();
    cannot_write(path_, "ffmpeg: " + child_->reason());
}

void Ffmpeg::add(const Image& image) {
    const bool pads = format_ == Format::Mp4 && (image.width % 2 != 0 || image.height % 2 != 0);
    const int width = pads ? even(image.width) : image.width;
    const int height = pads ? even(image.height) : image.height;
    if (!child_) start(width, height);
    if (!pads) {
        if (!child_->feed(image.rgba)) fail();
        return;
    }
    even_.clear();
    for (int j = 0; j < height; ++j) {
        const auto row = image.rgba.begin() + std::ptrdiff_t{4} * image.width * std::min(j, image.height - 1);
        const auto end = row + std::ptrdiff_t{4} * image.width;
        even_.insert(even_.end(), row, end);
        if (width > image.width) even_.insert(even_.end(), end - 4, end);
    }
    if (!child_->feed(even_)) fail();
}

void Ffmpeg::finish() {
    if (!child_->wait()) fail();
    std::error_code ignored;
    if (fs::file_size(file_.aside(), ignored) == 0) cannot_write(path_, "ffmpeg wrote nothing");
    file_.finish();
}

}  // namespace whorl::app
