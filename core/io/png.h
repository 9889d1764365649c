// Pictures as PNG files, with text inside.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace whorl {

/// `width × height` pixels, top row first, four bytes each: red, green, blue (sRGB) and straight alpha.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    bool operator==(const Image&) const = default;
};

/// A keyword (1 to 79 printable ASCII characters, none of them a space at either end) and UTF-8 text.
using TextChunk = std::pair<std::string, std::string>;

/// Longest side of a picture that is read or written, pixels.
inline constexpr int max_image_side = 16384;

/// Writes a picture and its text chunks. The file appears whole or not at all: it is written aside, then
/// renamed. An existing file is replaced.
/// @throws std::runtime_error with one line that names the file and the reason.
void write_png(const std::filesystem::path& path, const Image& image, std::span<const TextChunk> text = {});

/// Reads any PNG picture as 8-bit RGBA, and its text chunks in the file's order.
/// @param text  receives the chunks if not null
/// @throws std::runtime_error with one line that names the file and the reason if it is damaged, larger than
///         `max_image_side`, or claims more pixels or text than a file of its size can hold.
Image read_png(const std::filesystem::path& path, std::vector<TextChunk>* text = nullptr);

/// Asks, before a long run, whether a file could be written at `path`; leaves nothing behind and an existing
/// file as it is.
/// @throws std::runtime_error with one line that names the file and the reason if not.
void check_writable(const std::filesystem::path& path);

}  // namespace whorl
