// See png.h. libpng reports errors by longjmp: no function below that calls it holds an object with a
// destructor.
#include "core/io/png.h"

#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "core/io/png_source.h"
#include "core/io/whole_file.h"

namespace whorl {
namespace {

namespace fs = std::filesystem;

/// Shorter text stays legible in the file, and would not get much shorter.
constexpr std::size_t long_text = 1024;  // bytes
/// Deflate packs at most 1032 bytes into one.
constexpr std::uintmax_t max_deflate_ratio = 1032;

/// What libpng says last.
struct Message {
    char text[200] = "";
};

extern "C" void on_error(png_structp png, png_const_charp text) {
    auto* message = static_cast<Message*>(png_get_error_ptr(png));
    std::snprintf(message->text, sizeof message->text, "%s", text);
    png_longjmp(png, 1);
}
extern "C" void on_warning(png_structp, png_const_charp) {}

/// Owns libpng's structures for reading or writing.
struct Codec {
    explicit Codec(bool reads) : reading(reads) {
        png = reading ? png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning)
                      : png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning);
        info = png != nullptr ? png_create_info_struct(png) : nullptr;
        if (info == nullptr) {
            destroy();
            throw std::bad_alloc();
        }
    }
    ~Codec() { destroy(); }
    Codec(const Codec&) = delete;
    Codec& operator=(const Codec&) = delete;

    void destroy() {
        if (reading) {
            png_destroy_read_struct(&png, &info, nullptr);
        } else {
            png_destroy_write_struct(&png, &info);
        }
    }

    bool reading;
    Message message;
    png_structp png = nullptr;
    png_infop info = nullptr;
};

bool encode(Codec& codec, std::FILE* file, int width, int height, png_textp text, int texts,
            png_bytepp rows) {
    if (setjmp(png_jmpbuf(codec.png)) != 0) return false;
    png_init_io(codec.png, file);
    // A smooth picture packs nearly as well at 3 as at 6, in a third of the time.
    png_set_compression_level(codec.png, 3);
    png_set_filter(codec.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_IHDR(codec.png, codec.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(codec.png, codec.info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (texts > 0) png_set_text(codec.png, codec.info, text, texts);
    png_write_info(codec.png, codec.info);
    png_write_image(codec.png, rows);
    png_write_end(codec.png, nullptr);
    return true;
}

bool decode_header(Codec& codec, std::FILE* file) {
    if (setjmp(png_jmpbuf(codec.png)) != 0) return false;
    png_set_user_limits(codec.png, max_image_side, max_image_side);
    // Only what the pixels need: profiles, palettes of suggestion and text could fill the memory.
    png_set_keep_unknown_chunks(codec.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_init_io(codec.png, file);
    png_set_sig_bytes(codec.png, PngSource::signature_bytes);
    png_read_info(codec.png, codec.info);
    png_set_expand(codec.png);
    png_set_scale_16(codec.png);
    png_set_gray_to_rgb(codec.png);
    png_set_add_alpha(codec.png, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(codec.png);
    return true;
}

bool decode_pixels(Codec& codec, png_bytepp rows) {
    if (setjmp(png_jmpbuf(codec.png)) != 0) return false;
    png_read_update_info(codec.png, codec.info);
    png_read_image(codec.png, rows);
    png_read_end(codec.png, nullptr);
    return true;
}

std::vector<png_bytep> rows_of(std::uint8_t* pixels, int width, int height) {
    std::vector<png_bytep> rows(static_cast<std::size_t>(height));
    for (std::size_t j = 0; j < rows.size(); ++j) rows[j] = pixels + j * 4 * static_cast<std::size_t>(width);
    return rows;
}

bool is_keyword(const std::string& key) {
    if (key.empty() || key.size() > max_png_keyword || key.front() == ' ' || key.back() == ' ') return false;
    for (const char c : key) {
        if (c < ' ' || c > '~') return false;
    }
    return key.find("  ") == std::string::npos;
}

/// Why a file cannot hold this picture and its text, or nothing.
std::string objection(const Image& image, std::span<const TextChunk> text) {
    const std::int64_t pixels = std::int64_t{image.width} * image.height;
    if (image.width < 1 || image.height < 1 || image.width > max_image_side ||
        image.height > max_image_side || pixels > max_image_pixels ||
        image.rgba.size() != static_cast<std::size_t>(4 * pixels)) {
        return "a picture of " + std::to_string(image.width) + " × " + std::to_string(image.height) +
               " pixels is none";
    }
    std::size_t total = 0;
    for (const auto& [key, value] : text) {
        if (!is_keyword(key)) return "'" + key + "' is no PNG keyword";
        if (value.find('\0') != std::string::npos) return "text of a picture holds no zero byte";
        total += value.size();
    }
    if (total > max_png_text || text.size() > max_png_texts) return "a picture holds at most 64 MiB of text";
    return {};
}

Image read(PngSource& source, std::vector<TextChunk>* text) {
    Codec codec(true);
    if (!decode_header(codec, source.file.get())) source.fail(codec.message.text);
    const auto width = static_cast<int>(png_get_image_width(codec.png, codec.info));
    const auto height = static_cast<int>(png_get_image_height(codec.png, codec.info));
    const std::string size = std::to_string(width) + " × " + std::to_string(height) + " pixels";
    if (std::int64_t{width} * height > max_image_pixels) source.fail("it has too many pixels: " + size);
    if (png_get_rowbytes(codec.png, codec.info) * static_cast<std::uintmax_t>(height) / max_deflate_ratio >
        source.bytes) {
        source.fail("the file is too short for its " + size);
    }
    Image image{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
    auto rows = rows_of(image.rgba.data(), width, height);
    if (!decode_pixels(codec, rows.data())) source.fail(codec.message.text);
    if (text != nullptr) {
        std::fseek(source.file.get(), PngSource::signature_bytes, SEEK_SET);
        *text = read_png_text(source);
    }
    return image;
}

}  // namespace

void write_png(const fs::path& path, const Image& image, std::span<const TextChunk> text) {
    if (const std::string reason = objection(image, text); !reason.empty()) cannot_write(path, reason);
    std::vector<png_text> chunks(text.size());
    for (std::size_t k = 0; k < text.size(); ++k) {
        chunks[k].compression =
            text[k].second.size() > long_text ? PNG_ITXT_COMPRESSION_zTXt : PNG_ITXT_COMPRESSION_NONE;
        chunks[k].key = const_cast<char*>(text[k].first.c_str());
        chunks[k].text = const_cast<char*>(text[k].second.c_str());
        chunks[k].itxt_length = text[k].second.size();
    }
    // libpng only reads the rows it writes.
    auto rows = rows_of(const_cast<std::uint8_t*>(image.rgba.data()), image.width, image.height);

    WholeFile file(path);
    Codec codec(false);
    errno = 0;
    const bool encoded = encode(codec, file.stream(), image.width, image.height, chunks.data(),
                                static_cast<int>(chunks.size()), rows.data());
    const int disk = errno;
    if (!encoded) cannot_write(path, disk != 0 ? std::strerror(disk) : codec.message.text);
    file.finish();
}

Image read_png(const fs::path& path, std::vector<TextChunk>* text) {
    PngSource source(path);
    return read(source, text);
}

Image parse_png(std::string_view bytes, std::string_view name, std::vector<TextChunk>* text) {
    PngSource source(bytes, name);
    return read(source, text);
}

}  // namespace whorl
