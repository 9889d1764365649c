// Pictures to MP4 or GIF by the program ffmpeg, where it is installed.
#pragma once

#include <optional>
#include <vector>

#include "app/film/child.h"
#include "app/film/film.h"
#include "core/io/whole_file.h"

namespace whorl::app {

class Ffmpeg : public FilmWriter {
  public:
    enum class Format { Mp4, Gif };

    /// @throws std::runtime_error if there is no ffmpeg, it cannot write the format, or the file cannot be
    /// written
    Ffmpeg(const std::filesystem::path& path, Format format, int frames_per_second);

    /// The first picture starts ffmpeg: it must be told the size.
    void add(const Image& image) override;
    void finish() override;

  private:
    void start(int width, int height);
    /// Throws what ffmpeg said last.
    [[noreturn]] void fail();

    std::filesystem::path path_;
    Format format_;
    int frames_per_second_;
    std::string program_;
    std::vector<std::string> encoder_;  // its options
    WholeFile file_;
    std::optional<Child> child_;
    std::vector<std::uint8_t> even_;  // a picture with its last column and row repeated
};

}  // namespace whorl::app
