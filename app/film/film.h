// An animation: MP4 or GIF through ffmpeg, or numbered pictures.
#pragma once

#include <filesystem>
#include <memory>

#include "core/io/png.h"

namespace whorl::app {

/// What takes the pictures of a film, one after the other.
class FilmWriter {
  public:
    virtual ~FilmWriter() = default;
    virtual void add(const Image& image) = 0;
    virtual void finish() = 0;
};

/// @param option  that gives the name
/// @throws InputError if no film has such a name
void check_film_name(const std::string& option, const std::filesystem::path& path);

/// A film in the making. The name decides what is made: `NAME.mp4` and `NAME.gif` need ffmpeg; a name with
/// one number in it, as `frames/%04d.png` (`%d`, or `%0Nd` with N from 1 to 9), makes pictures that count
/// from 1 and need nothing. MP4 and GIF appear when the film is finished, and not at all otherwise. Numbered
/// pictures appear one by one, each of them whole, and stay if the film is broken off. All errors are
/// std::runtime_error with one line that names the film and the reason; after one, the film is over.
class Film {
  public:
    /// @param frames_per_second  1 to 240; a GIF shows at most 50 and leaves the others out, numbered
    /// pictures have
    ///                           none
    /// @throws std::runtime_error whatever can be known before the first picture: a name that is none, no
    /// directory
    ///         to write to, no ffmpeg or one that cannot write this
    Film(const std::filesystem::path& path, int frames_per_second);
    /// Takes an unfinished MP4 or GIF away.
    ~Film();

    /// @param image  as large as the first one; transparency is left out of MP4 and GIF
    /// @throws std::runtime_error
    void add(const Image& image);
    /// @throws std::runtime_error, also if there was no picture
    void finish();

  private:
    std::filesystem::path path_;
    std::unique_ptr<FilmWriter> writer_;
    int width_ = 0, height_ = 0;  ///< of the first picture, pixels; 0: there was none
};

}  // namespace whorl::app
