#include "app/film/film.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <optional>
#include <string>

#include "app/film/ffmpeg.h"
#include "core/base/error.h"
#include "core/io/whole_file.h"

namespace whorl::app {
namespace {

namespace fs = std::filesystem;

constexpr int max_frames_per_second = 240;
constexpr const char* film_names =
    "a film is NAME.mp4, NAME.gif, or numbered pictures such as frames/%04d.png";

/// `before%04dafter` taken apart.
struct NumberedName {
    std::string before, after;
    int digits = 0;

    fs::path of(int number) const {
        std::string figures = std::to_string(number);
        if (figures.size() < static_cast<std::size_t>(digits))
            figures.insert(0, digits - figures.size(), '0');
        return before + figures + after;
    }
};

/// Nothing if there is not exactly one number in the name of a PNG file.
std::optional<NumberedName> numbered_name(const fs::path& path) {
    const std::string text = path.string();
    const std::size_t at = text.find('%');
    if (at == text.npos || path.extension() != ".png" || at < text.size() - path.filename().string().size())
        return std::nullopt;
    NumberedName name{text.substr(0, at), text.substr(at + 1), 0};
    if (name.after.size() > 2 && name.after[0] == '0' && name.after[1] >= '1' && name.after[1] <= '9') {
        name.digits = name.after[1] - '0';
        name.after.erase(0, 2);
    }
    if (!name.after.starts_with('d') || name.after.find('%') != name.after.npos) return std::nullopt;
    name.after.erase(0, 1);
    return name;
}

/// Each picture is a file of its own.
class NumberedPictures : public FilmWriter {
  public:
    explicit NumberedPictures(NumberedName name) : name_(std::move(name)) { check_writable(name_.of(1)); }
    void add(const Image& image) override { write_png(name_.of(++count_), image); }
    void finish() override {}

  private:
    NumberedName name_;
    int count_ = 0;
};

/// The name's ending, in small letters.
std::string kind_of(const fs::path& path) {
    std::string kind = path.extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(), [](unsigned char c) { return std::tolower(c); });
    return kind;
}

std::unique_ptr<FilmWriter> writer_for(const fs::path& path, int frames_per_second) {
    if (frames_per_second < 1 || frames_per_second > max_frames_per_second)
        cannot_write(path, "a film has 1 to 240 frames per second");
    if (auto name = numbered_name(path)) return std::make_unique<NumberedPictures>(std::move(*name));
    const std::string kind = kind_of(path);
    if (kind == ".mp4") return std::make_unique<Ffmpeg>(path, Ffmpeg::Format::Mp4, frames_per_second);
    if (kind == ".gif") return std::make_unique<Ffmpeg>(path, Ffmpeg::Format::Gif, frames_per_second);
    cannot_write(path, film_names);
}

std::string size_of(int width, int height) {
    return std::to_string(width) + " × " + std::to_string(height);
}

}  // namespace

void check_film_name(const std::string& option, const fs::path& path) {
    if (!numbered_name(path) && kind_of(path) != ".mp4" && kind_of(path) != ".gif")
        throw InputError(option + " = " + path.string() + ": " + film_names);
}

Film::Film(const fs::path& path, int frames_per_second)
    : path_(path), writer_(writer_for(path, frames_per_second)) {}

Film::~Film() = default;

void Film::add(const Image& image) {
    if (width_ == 0) {
        width_ = image.width;
        height_ = image.height;
    }
    if (image.width != width_ || image.height != height_) {
        cannot_write(path_, "its pictures are " + size_of(width_, height_) + " pixels, and one is " +
                                size_of(image.width, image.height));
    }
    writer_->add(image);
}

void Film::finish() {
    if (width_ == 0) cannot_write(path_, "a film without a picture is none");
    writer_->finish();
}

}  // namespace whorl::app
