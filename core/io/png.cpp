// See png.h. libpng reports errors by longjmp: no function below that calls it holds an object with a
// destructor.
#include "core/io/png.h"

#include <png.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace whorl {
namespace {

namespace fs = std::filesystem;

/// Text and colour profiles of a picture of ours are a few kilobytes; one chunk may take this much memory,
/// bytes.
constexpr png_alloc_size_t max_chunk_bytes = 8u << 20;
constexpr int max_chunks = 256;
/// Deflate packs at most 1032 bytes into one.
constexpr std::uintmax_t max_deflate_ratio = 1032;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(const char* verb, const fs::path& path, const std::string& reason) {
    throw std::runtime_error(std::string("cannot ") + verb + " " + path.string() + ": " + reason);
}

std::string reason_of(int error) {
    return error == 0 ? "the disk gave no reason" : std::strerror(error);
}

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
    png_set_chunk_malloc_max(codec.png, max_chunk_bytes);
    png_set_chunk_cache_max(codec.png, max_chunks);
    png_init_io(codec.png, file);
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
    png_read_end(codec.png, codec.info);
    return true;
}

std::vector<png_bytep> rows_of(std::uint8_t* pixels, int width, int height) {
    std::vector<png_bytep> rows(static_cast<std::size_t>(height));
    for (std::size_t j = 0; j < rows.size(); ++j) rows[j] = pixels + j * 4 * static_cast<std::size_t>(width);
    return rows;
}

bool is_keyword(const std::string& key) {
    if (key.empty() || key.size() > 79 || key.front() == ' ' || key.back() == ' ') return false;
    for (const char c : key) {
        if (c < ' ' || c > '~') return false;
    }
    return key.find("  ") == std::string::npos;
}

/// Opens a new file beside `path`, to be renamed to it.
std::pair<File, fs::path> open_aside(const fs::path& path) {
    if (path.empty() || !path.has_filename()) fail("write", path, "this names no file");
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) fail("write", path, "this is a directory");
    // Renaming onto a device or a pipe would take its place.
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
        fail("write", path, "this is no file");
    const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::exists(parent, ignored)) fail("write", path, "there is no directory " + parent.string());
    std::string aside = path.string() + ".part-XXXXXX";
    const int descriptor = ::mkstemp(aside.data());
    if (descriptor < 0) fail("write", path, reason_of(errno));
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::fchmod(descriptor, 0666 & ~mask);
    std::FILE* file = ::fdopen(descriptor, "wb");
    if (file == nullptr) {
        ::close(descriptor);
        fs::remove(aside, ignored);
        fail("write", path, "out of memory");
    }
    return {File(file), aside};
}

}  // namespace

void write_png(const fs::path& path, const Image& image, std::span<const TextChunk> text) {
    if (image.width < 1 || image.height < 1 || image.width > max_image_side ||
        image.height > max_image_side || image.rgba.size() != std::size_t{4} * image.width * image.height) {
        fail("write", path,
             "a picture of " + std::to_string(image.width) + " × " + std::to_string(image.height) +
                 " pixels is none");
    }
    std::vector<png_text> chunks(text.size());
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (!is_keyword(text[k].first)) fail("write", path, "'" + text[k].first + "' is no PNG keyword");
        chunks[k].compression = PNG_ITXT_COMPRESSION_NONE;
        chunks[k].key = const_cast<char*>(text[k].first.c_str());
        chunks[k].text = const_cast<char*>(text[k].second.c_str());
        chunks[k].itxt_length = text[k].second.size();
    }
    // libpng only reads the rows it writes.
    auto rows = rows_of(const_cast<std::uint8_t*>(image.rgba.data()), image.width, image.height);

    auto [file, aside] = open_aside(path);
    std::error_code error;
    try {
        Codec codec(false);
        errno = 0;
        const bool encoded = encode(codec, file.get(), image.width, image.height, chunks.data(),
                                    static_cast<int>(chunks.size()), rows.data());
        const int disk = errno;
        if (!encoded) fail("write", path, disk != 0 ? reason_of(disk) : codec.message.text);
        errno = 0;
        if (std::fclose(file.release()) != 0) fail("write", path, reason_of(errno));
        fs::rename(aside, path, error);
        if (error) fail("write", path, error.message());
    } catch (...) {
        fs::remove(aside, error);
        throw;
    }
}

Image read_png(const fs::path& path, std::vector<TextChunk>* text) {
    std::error_code error;
    const auto status = fs::status(path, error);
    if (!fs::exists(status)) fail("read", path, "there is no such file");
    if (!fs::is_regular_file(status)) fail("read", path, "this is no file");
    const std::uintmax_t bytes = fs::file_size(path, error);
    errno = 0;
    const File file(std::fopen(path.c_str(), "rb"));
    if (file == nullptr) fail("read", path, reason_of(errno));

    png_byte signature[8] = {};
    if (std::fread(signature, 1, sizeof signature, file.get()) != sizeof signature ||
        png_sig_cmp(signature, 0, sizeof signature) != 0) {
        fail("read", path, "this is no PNG picture");
    }
    std::rewind(file.get());

    Codec codec(true);
    if (!decode_header(codec, file.get())) fail("read", path, codec.message.text);
    const auto width = static_cast<int>(png_get_image_width(codec.png, codec.info));
    const auto height = static_cast<int>(png_get_image_height(codec.png, codec.info));
    if (png_get_rowbytes(codec.png, codec.info) * static_cast<std::uintmax_t>(height) / max_deflate_ratio >
        bytes) {
        fail("read", path,
             "the file is too short for its " + std::to_string(width) + " × " + std::to_string(height) +
                 " pixels");
    }
    Image image{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
    auto rows = rows_of(image.rgba.data(), width, height);
    if (!decode_pixels(codec, rows.data())) fail("read", path, codec.message.text);

    if (text != nullptr) {
        text->clear();
        png_textp chunks = nullptr;
        const int count = png_get_text(codec.png, codec.info, &chunks, nullptr);
        for (int k = 0; k < count; ++k) {
            const std::size_t length = chunks[k].compression >= PNG_ITXT_COMPRESSION_NONE
                                           ? chunks[k].itxt_length
                                           : chunks[k].text_length;
            text->emplace_back(chunks[k].key,
                               chunks[k].text != nullptr ? std::string(chunks[k].text, length) : "");
        }
    }
    return image;
}

void check_writable(const fs::path& path) {
    auto [file, aside] = open_aside(path);
    file.reset();
    std::error_code ignored;
    fs::remove(aside, ignored);
}

}  // namespace whorl
