// Hostile pictures: their structure is taken apart, spoilt, and put together again with the right checksums.
#include <zlib.h>

#include <algorithm>
#include <stdexcept>

#include "core/io/png.h"
#include "tests/fuzz/fuzz.h"

namespace whorl::fuzz {
namespace {

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);

/// The readers under test.
void read_text(const std::string& bytes) {
    parse_png_text(bytes, input_name);
}
void read_picture(const std::string& bytes) {
    std::vector<TextChunk> text;
    parse_png(bytes, input_name, &text);
}

struct Chunk {
    std::string type, data;
};

std::string big_endian(std::uint64_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
    return bytes;
}

std::string deflated(const std::string& text) {
    uLongf size = compressBound(text.size());
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
             text.size());
    packed.resize(size);
    return packed;
}

std::string joined(const std::vector<Chunk>& chunks) {
    std::string file(signature);
    for (const auto& [type, data] : chunks) {
        const std::string body = type + data;
        file +=
            big_endian(data.size()) + body +
            big_endian(crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
    }
    return file;
}

/// The chunks as far as their lengths make sense; the first spoilt one takes the rest.
std::vector<Chunk> split(const std::string& file) {
    std::vector<Chunk> chunks;
    for (std::size_t at = signature.size(); at + 12 <= file.size();) {
        std::size_t length = 0;
        for (int k = 0; k < 4; ++k) length = length << 8 | static_cast<unsigned char>(file[at + k]);
        length = std::min(length, file.size() - at - 12);
        chunks.push_back({file.substr(at + 4, 4), file.substr(at + 8, length)});
        at += 12 + length;
    }
    return chunks;
}

std::string header(std::uint64_t width, std::uint64_t height, int depth, int colours, int interlace) {
    return big_endian(width) + big_endian(height) + static_cast<char>(depth) + static_cast<char>(colours) +
           std::string(2, '\0') + static_cast<char>(interlace);
}

/// A small picture of every kind of pixel, and text of every kind.
std::vector<std::string> corpus() {
    using std::string_literals::operator""s;
    std::vector<std::string> files;
    constexpr int kinds[][2] = {{0, 1}, {0, 2}, {0, 4}, {0, 8},  {0, 16}, {2, 8}, {2, 16},
                                {3, 1}, {3, 8}, {4, 8}, {4, 16}, {6, 8},  {6, 16}};
    const std::vector<Chunk> texts{{"tEXt", "Software\0Whorl"s},
                                   {"zTXt", "Note\0\0"s + deflated("a note\n")},
                                   {"iTXt", "Scene\0\0\0en\0Szene\0ζ = 3"s},
                                   {"iTXt", "Run\0\1\0\0\0"s + deflated(std::string(5000, 'r'))}};
    for (const auto& [colours, depth] : kinds) {
        for (const int interlace : {0, 1}) {
            std::vector<Chunk> chunks{{"IHDR", header(7, 5, depth, colours, interlace)}};
            if (colours == 3) chunks.push_back({"PLTE", "\1\2\3\4\5\6"});
            if (colours == 3) chunks.push_back({"tRNS", "\7"});
            chunks.insert(chunks.end(), texts.begin(), texts.end());
            chunks.push_back({"IDAT", deflated(std::string(1000, '\0'))});
            chunks.push_back({"IEND", ""});
            files.push_back(joined(chunks));
        }
    }
    return files;
}

/// A stream of 300 MB: it would double into more than the memory there is. A block that is flushed in full
/// does not need those before it, so one is packed and repeated.
std::string bomb() {
    constexpr std::size_t header_bytes = 2;
    std::string block(1'000'000, 'x'), packed(10'000, '\0');
    z_stream stream{};
    deflateInit(&stream, Z_DEFAULT_COMPRESSION);
    stream.next_in = reinterpret_cast<Bytef*>(block.data());
    stream.avail_in = static_cast<uInt>(block.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FULL_FLUSH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    std::string whole = packed;
    for (int k = 1; k < 300; ++k) whole += packed.substr(header_bytes);
    return whole;
}

std::string hostile_stream(Random& random) {
    if (random.one_in(300)) return bomb();
    std::string stream = deflated(std::string(random.below(5000), static_cast<char>(random())));
    if (random.one_in(2)) stream[random.below(stream.size())] = static_cast<char>(random());
    if (random.one_in(4)) stream.resize(random.below(stream.size()));
    return stream;
}

void mutate_chunks(std::vector<Chunk>& chunks, Random& random) {
    using std::string_literals::operator""s;
    static const std::vector<std::string> types{"IHDR", "IDAT", "IEND", "PLTE", "tRNS", "tEXt", "zTXt",
                                                "iTXt", "iCCP", "sPLT", "eXIf", "gAMA", "hIST", "prVt"};
    static const std::vector<std::uint64_t> sizes{0,    1,     16383,      16384,      16385,
                                                  8192, 65536, 0x7fffffff, 0x80000000, 0xffffffff};
    if (chunks.empty()) chunks.push_back({"IHDR", header(1, 1, 8, 6, 0)});
    const std::size_t at = random.below(chunks.size());
    const std::vector<std::string> others{chunks[random.below(chunks.size())].data};
    switch (random.below(8)) {
        case 0:
            chunks[0] = {"IHDR",
                         header(random.of(sizes), random.of(sizes), 1 << random.below(5),
                                static_cast<int>(random.below(8)), static_cast<int>(random.below(3)))};
            break;
        case 1:
            chunks.erase(chunks.begin() + at);
            break;
        case 2:
            std::swap(chunks[at], chunks[random.below(chunks.size())]);
            break;
        case 3:
            chunks.insert(chunks.begin() + at, random.one_in(20) ? 300 : 1, Chunk(chunks[at]));
            break;
        case 4:
            chunks[at].type = random.of(types);
            break;
        case 5:
            chunks.insert(chunks.begin() + at, {"zTXt", "Run\0\0"s + hostile_stream(random)});
            break;
        case 6:
            chunks.insert(chunks.begin() + at, {random.of(types), "Run\0\1\0\0\0"s + hostile_stream(random)});
            break;
        default:
            if (chunks[at].type == "IDAT" && random.one_in(2)) {
                chunks[at].data = hostile_stream(random);
            } else {
                mutate_bytes(chunks[at].data, random, others, types);
            }
    }
}

}  // namespace
}  // namespace whorl::fuzz

int main(int argc, char** argv) {
    using namespace whorl::fuzz;
    const std::vector<std::string> files = corpus();
    const std::vector<std::string> words{std::string(signature), "IDAT", "IEND", std::string(4, '\0'),
                                         "\xff\xff\xff\xff"};
    const auto mutate = [&](std::string& input, Random& random) {
        if (random.one_in(6)) {
            mutate_bytes(input, random, files, words);
            return;
        }
        std::vector<Chunk> chunks = split(input);
        mutate_chunks(chunks, random);
        input = joined(chunks);
    };
    const auto refuse = [](const std::string& input) {
        const std::string complaint = complaint_about<std::runtime_error>([&] { read_text(input); });
        return complaint.empty() ? complaint_about<std::runtime_error>([&] { read_picture(input); })
                                 : complaint;
    };
    return run({"png", files, mutate, refuse}, argc, argv);
}
