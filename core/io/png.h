// Pictures as PNG files, with text inside.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
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
/// Most pixels of one: 256 MiB in memory. Few bytes of a file can stand for many pixels of one colour.
inline constexpr std::int64_t max_image_pixels = std::int64_t{1} << 26;
/// Largest file that is read, bytes: no picture of so many pixels packs worse.
inline constexpr std::uintmax_t max_png_bytes = std::uintmax_t{1} << 30;
/// Text in one file, unpacked, bytes.
inline constexpr std::size_t max_png_text = std::size_t{64} << 20;
/// Text chunks in one file.
inline constexpr std::size_t max_png_texts = 256;
/// Length of a keyword, bytes.
inline constexpr std::size_t max_png_keyword = 79;

/// Writes a picture and its text chunks; long text is compressed. The file appears whole or not at all, see
/// WholeFile. An existing file is replaced.
/// @param text  holds no zero byte: PNG ends a text there
/// @throws std::runtime_error with one line that names the file and the reason.
void write_png(const std::filesystem::path& path, const Image& image, std::span<const TextChunk> text = {});

/// Reads any PNG picture as 8-bit RGBA, and its text chunks as read_png_text does.
/// @param text  receives the chunks if not null
/// @throws std::runtime_error with one line that names the file and the reason if it is damaged, beyond one
/// of
///         the limits above, or claims more pixels than a file of its size can hold.
Image read_png(const std::filesystem::path& path, std::vector<TextChunk>* text = nullptr);

/// Reads a picture from memory.  @param name  what errors call it
Image parse_png(std::string_view bytes, std::string_view name, std::vector<TextChunk>* text = nullptr);

/// Reads the text chunks alone, in the file's order, whatever the pixels hold. Every checksum is compared.
/// Takes time in proportion to the file, and memory for twice `max_png_text` at most.
/// @throws std::runtime_error as read_png
std::vector<TextChunk> read_png_text(const std::filesystem::path& path);
std::vector<TextChunk> parse_png_text(std::string_view bytes, std::string_view name);

}  // namespace whorl
