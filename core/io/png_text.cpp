// Text inside a PNG file, read without its pixels.
#include <zlib.h>

#include <algorithm>
#include <array>

#include "core/io/png.h"
#include "core/io/png_source.h"

namespace whorl {
namespace {

constexpr std::size_t piece = std::size_t{1} << 16;  // what is read or inflated at a time, bytes

std::uint32_t big_endian(const char* bytes) {
    std::uint32_t value = 0;
    for (int k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
    return value;
}

std::string utf8_of_latin1(std::string_view text) {
    std::string utf8;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x80) {
            utf8 += c;
        } else {
            utf8 += static_cast<char>(0xc0 | code >> 6);
            utf8 += static_cast<char>(0x80 | (code & 0x3f));
        }
    }
    return utf8;
}

/// Takes the chunks of a file one after the other.
class ChunkReader {
  public:
    explicit ChunkReader(PngSource& source)
        : source_(source), left_(source.bytes - PngSource::signature_bytes) {}

    std::vector<TextChunk> texts();

  private:
    static bool is_text(std::string_view type) { return type == "tEXt" || type == "zTXt" || type == "iTXt"; }

    void read(char* to, std::size_t count) {
        if (count > left_ || std::fread(to, 1, count, source_.file.get()) != count)
            source_.fail("the file is cut short");
        left_ -= count;
    }
    std::string body(std::string_view type, std::size_t length);
    TextChunk text_of(std::string_view type, std::string_view data);
    std::string inflated(std::string_view data);
    /// Cuts `data` behind its first zero, and returns what stood before it.
    std::string_view until_zero(std::string_view& data) const {
        const std::size_t zero = data.find('\0');
        if (zero == data.npos) source_.fail("its text is damaged");
        const std::string_view word = data.substr(0, zero);
        data.remove_prefix(zero + 1);
        return word;
    }
    /// Counts text against the limit.
    void spend(std::size_t bytes) {
        if (bytes > budget_) source_.fail("it holds more than 64 MiB of text");
        budget_ -= bytes;
    }

    PngSource& source_;
    std::uintmax_t left_;                // of the file, bytes
    std::size_t budget_ = max_png_text;  // of text still allowed, bytes
};

/// A chunk's bytes, if they are text; its checksum is compared in any case.
std::string ChunkReader::body(std::string_view type, std::size_t length) {
    if (length > left_) source_.fail("the file is cut short");
    std::string data;
    std::array<char, piece> buffer;
    uLong sum = ::crc32(0, reinterpret_cast<const Bytef*>(type.data()), static_cast<uInt>(type.size()));
    while (length > 0) {
        const std::size_t count = std::min(length, piece);
        read(buffer.data(), count);
        sum = ::crc32(sum, reinterpret_cast<const Bytef*>(buffer.data()), static_cast<uInt>(count));
        if (is_text(type)) data.append(buffer.data(), count);
        length -= count;
    }
    char stored[4];
    read(stored, sizeof stored);
    if (big_endian(stored) != sum) source_.fail("a checksum is wrong: the file is damaged");
    return data;
}

std::string ChunkReader::inflated(std::string_view data) {
    z_stream stream{};
    if (::inflateInit(&stream) != Z_OK) throw std::bad_alloc();
    struct End {
        z_stream* stream;
        ~End() { ::inflateEnd(stream); }
    } const end{&stream};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
    stream.avail_in = static_cast<uInt>(data.size());
    std::string text;
    std::array<char, piece> buffer;
    for (int state = Z_OK; state != Z_STREAM_END;) {
        stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
        stream.avail_out = static_cast<uInt>(piece);
        state = ::inflate(&stream, Z_NO_FLUSH);
        if (state != Z_OK && state != Z_STREAM_END) source_.fail("its compressed text is damaged");
        spend(piece - stream.avail_out);
        text.append(buffer.data(), piece - stream.avail_out);
    }
    return text;
}

/// PNG specification, sections 11.3.3.2 to 11.3.3.4.
TextChunk ChunkReader::text_of(std::string_view type, std::string_view data) {
    const std::string_view key = until_zero(data);
    if (key.empty() || key.size() > max_png_keyword) source_.fail("its text is damaged");
    bool compressed = type == "zTXt";
    if (type != "tEXt") {
        const std::size_t flags = type == "iTXt" ? 2 : 1;  // whether it is compressed, and how
        if (data.size() < flags) source_.fail("its text is damaged");
        if (type == "iTXt") compressed = data[0] != 0;
        if (compressed && data[flags - 1] != 0) source_.fail("its text is compressed in an unknown way");
        data.remove_prefix(flags);
    }
    if (type == "iTXt") {
        until_zero(data);  // language
        until_zero(data);  // translated keyword
    }
    if (!compressed) spend(data.size());
    std::string text = compressed ? inflated(data) : std::string(data);
    if (type != "iTXt") text = utf8_of_latin1(text);
    return {utf8_of_latin1(key), std::move(text)};
}

std::vector<TextChunk> ChunkReader::texts() {
    std::vector<TextChunk> texts;
    for (bool first = true;; first = false) {
        char head[8];  // length and type
        read(head, sizeof head);
        const std::size_t length = big_endian(head);
        const std::string_view type(head + 4, 4);
        if (first && type != "IHDR") source_.fail("it does not begin with a size");
        if (is_text(type)) {
            if (texts.size() == max_png_texts || length > max_png_text)
                source_.fail("it holds more text than any picture of ours");
            texts.push_back(text_of(type, body(type, length)));
        } else {
            body(type, length);
        }
        if (type == "IEND") return texts;
    }
}

}  // namespace

std::vector<TextChunk> read_png_text(PngSource& source) {
    return ChunkReader(source).texts();
}

std::vector<TextChunk> read_png_text(const std::filesystem::path& path) {
    PngSource source(path);
    return read_png_text(source);
}

std::vector<TextChunk> parse_png_text(std::string_view bytes, std::string_view name) {
    PngSource source(bytes, name);
    return read_png_text(source);
}

}  // namespace whorl
