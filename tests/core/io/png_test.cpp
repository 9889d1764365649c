// PNG files: what is written is read, and what is no picture is refused.
#include "core/io/png.h"

#include <zlib.h>

#include "core/io/whole_file.h"
#include "tests/support/full_disk.h"
#include "tests/support/own_directory.h"

namespace whorl {
namespace {

namespace fs = std::filesystem;

class Png : public test::OwnDirectory {
  protected:
    void SetUp() override {
        OwnDirectory::SetUp();
        file_ = directory_ / "picture.png";
        for (int k = 0; k < 5 * 3 * 4; ++k) image_.rgba.push_back(static_cast<std::uint8_t>(k * 37));
    }

    std::string bytes() const { return contents(file_); }
    void put(const std::string& text) const { OwnDirectory::put(file_, text); }
    std::string refusal() const {
        return complaint([&] { read_png(file_); });
    }
    std::string text_refusal() const {
        return complaint([&] { read_png_text(file_); });
    }
    static std::string big_endian(std::uint32_t value) {
        std::string bytes;
        for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> (24 - 8 * k));
        return bytes;
    }
    static std::string chunk(const std::string& type, const std::string& data) {
        const std::string body = type + data;
        const auto sum =
            crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
        return big_endian(static_cast<std::uint32_t>(data.size())) + body +
               big_endian(static_cast<std::uint32_t>(sum));
    }
    static std::string deflated(const std::string& text) {
        uLongf size = compressBound(text.size());
        std::string packed(size, '\0');
        compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                 text.size());
        packed.resize(size);
        return packed;
    }
    /// Puts chunks behind the header of the picture.
    void put_with(const std::string& chunks) const {
        write_png(file_, image_);
        std::string whole = bytes();
        constexpr std::size_t header = 8 + 12 + 13;
        put(whole.insert(header, chunks));
    }

    fs::path file_;
    Image image_{5, 3, {}};
};

TEST_F(Png, KeepsPixelsAndText) {
    const std::vector<TextChunk> text{
        {"Scene", "grid = [64, 64]\n# ∇·u = 0\n"}, {"Empty", ""}, {"Long", std::string(100'000, 'x')}};
    write_png(file_, image_, text);
    std::vector<TextChunk> back;
    EXPECT_EQ(read_png(file_, &back), image_);
    EXPECT_EQ(back, text);
    EXPECT_EQ(files(), 1u);
    EXPECT_EQ(read_png(file_), image_) << "text may be left out";
    EXPECT_EQ(read_png_text(file_), text);
    EXPECT_EQ(parse_png(bytes(), "memory", &back), image_);
    EXPECT_EQ(back, text);
    EXPECT_EQ(parse_png_text(bytes(), "memory"), text);
}

TEST_F(Png, PacksLongText) {
    std::string run = "# ζ = 3, ∇·u = 0, 🌀\n";
    while (run.size() < 4u << 20) run += "[" + std::to_string(run.size()) + ", 0.25, \"Größe\"]\n";
    const std::vector<TextChunk> text{{"Run", run}, {"Software", "Whorl"}};
    write_png(file_, image_, text);
    EXPECT_EQ(read_png_text(file_), text);
    EXPECT_LT(fs::file_size(file_), run.size() / 4);
}

TEST_F(Png, ReadsTextWithoutPixels) {
    write_png(file_, image_, std::vector<TextChunk>{{"Scene", "text"}});
    std::string damaged = bytes();
    // The pixels' stream is spoilt, its checksum made right.
    const std::size_t at = damaged.find("IDAT");
    damaged = damaged.substr(0, at - 4) + chunk("IDAT", "nonsense") + chunk("IEND", "");
    put(damaged);
    EXPECT_NE(refusal(), "");
    EXPECT_EQ(read_png_text(file_), (std::vector<TextChunk>{{"Scene", "text"}}));
}

TEST_F(Png, ReadsTextOfOtherPrograms) {
    using std::string_literals::operator""s;
    put_with(chunk("tEXt",
                   "Author\0Gr\xfc\xdf"s
                   "e"s) +
             chunk("zTXt", "Note\0\0"s + deflated("\xb5m")) +
             chunk("iTXt", "Title\0\1\0de\0Titel\0"s + deflated("Wirbel, ζ")) + chunk("prVt", "ignored"));
    const std::vector<TextChunk> text{{"Author", "Grüße"}, {"Note", "µm"}, {"Title", "Wirbel, ζ"}};
    EXPECT_EQ(read_png_text(file_), text);
    std::vector<TextChunk> back;
    EXPECT_EQ(read_png(file_, &back), image_);
    EXPECT_EQ(back, text);
}

TEST_F(Png, RefusesTextThatWouldFillTheMemory) {
    using std::string_literals::operator""s;
    const std::string bomb = deflated(std::string(max_png_text + 1, 'x'));
    put_with(chunk("zTXt", "Run\0\0"s + bomb));
    EXPECT_EQ(text_refusal(), "cannot read " + file_.string() + ": it holds more than 64 MiB of text");
    put_with(chunk("iTXt", "Run\0\1\0\0\0"s + bomb));
    EXPECT_EQ(text_refusal(), "cannot read " + file_.string() + ": it holds more than 64 MiB of text");
    EXPECT_EQ(read_png(file_), image_) << "who wants the pixels alone does not unpack it";
    // The limit holds for all chunks together.
    std::string many;
    for (int k = 0; k < 5; ++k) many += chunk("zTXt", "Run\0\0"s + deflated(std::string(16u << 20, 'x')));
    put_with(many);
    EXPECT_EQ(text_refusal(), "cannot read " + file_.string() + ": it holds more than 64 MiB of text");
    many.clear();
    for (std::size_t k = 0; k <= max_png_texts; ++k) many += chunk("tEXt", "a\0b"s);
    put_with(many);
    EXPECT_NE(text_refusal().find("more text than"), std::string::npos);
}

TEST_F(Png, RefusesDamagedText) {
    using std::string_literals::operator""s;
    const std::string packed = deflated("some text");
    for (const std::string& damaged :
         {chunk("tEXt", ""), chunk("tEXt", "no end"), chunk("tEXt", "\0no key"s),
          chunk("tEXt", std::string(80, 'k') + "\0x"s), chunk("zTXt", "k\0"s),
          chunk("zTXt", "k\0\1"s + packed), chunk("zTXt", "k\0\0"s),
          chunk("zTXt", "k\0\0"s + packed.substr(0, packed.size() - 1)), chunk("zTXt", "k\0\0nonsense"s),
          chunk("iTXt", "k\0\0"s), chunk("iTXt", "k\0\0\0en"s), chunk("iTXt", "k\0\0\0en\0no end"s)}) {
        put_with(damaged);
        EXPECT_NE(text_refusal().find("text is "), std::string::npos) << damaged;
    }
    put_with(chunk("tEXt", "key\0text"s));
    std::string flipped = bytes();
    flipped[flipped.find("text")] ^= 1;
    put(flipped);
    EXPECT_NE(text_refusal().find("checksum"), std::string::npos);
    std::string long_chunk = bytes();
    long_chunk.replace(33, 4, "\x7f\xff\xff\xff");
    put(long_chunk);
    EXPECT_NE(text_refusal(), "");
}

TEST_F(Png, RefusesAFileLargerThanAny) {
    write_png(file_, image_);
    fs::resize_file(file_, max_png_bytes + 1);  // takes no room: it has a hole
    EXPECT_NE(refusal().find("larger than"), std::string::npos);
    EXPECT_NE(text_refusal().find("larger than"), std::string::npos);
}

TEST_F(Png, OnAFullDiskIsNoPicture) {
    put("old");
    const Image large{256, 256, std::vector<std::uint8_t>(256 * 256 * 4, 7)};
    for (const rlim_t room : {0u, 100u}) {
        EXPECT_EQ(test::on_full_disk(room, [&] { write_png(file_, large); }),
                  "cannot write " + file_.string() + ": File too large");
        EXPECT_EQ(bytes(), "old");
        EXPECT_EQ(files(), 1u);
    }
}

TEST_F(Png, ReplacesAFile) {
    put("old");
    write_png(file_, image_);
    EXPECT_EQ(read_png(file_), image_);
    EXPECT_EQ(files(), 1u);
}

TEST_F(Png, RefusesWhatIsNoPicture) {
    EXPECT_NE(refusal().find("no such file"), std::string::npos);
    for (const std::string& text : {std::string(), std::string("GIF89a"), std::string(4096, '\0')}) {
        put(text);
        EXPECT_NE(refusal().find("no PNG picture"), std::string::npos);
    }
    EXPECT_THROW(read_png(directory_), std::runtime_error);
    EXPECT_THROW(read_png("/dev/zero"), std::runtime_error);
}

TEST_F(Png, RefusesEveryTruncation) {
    write_png(file_, image_, std::vector<TextChunk>{{"Scene", "text"}});
    const std::string whole = bytes();
    for (std::size_t length = 0; length < whole.size(); ++length) {
        put(whole.substr(0, length));
        const std::string reason = refusal();
        EXPECT_NE(reason.find(file_.string()), std::string::npos) << length;
        EXPECT_EQ(reason.find('\n'), std::string::npos);
        EXPECT_NE(text_refusal().find(file_.string()), std::string::npos) << length;
    }
}

TEST_F(Png, SurvivesFlippedBytes) {
    write_png(file_, image_, std::vector<TextChunk>{{"Scene", "text"}});
    const std::string whole = bytes();
    for (std::size_t k = 8; k < whole.size(); ++k) {
        std::string damaged = whole;
        damaged[k] = static_cast<char>(damaged[k] ^ 0x5a);
        put(damaged);
        refusal();  // an ancillary chunk may be skipped: the point is that nothing crashes
    }
}

/// The file with another size in its header, checksum made right.
std::string with_size(std::string png, std::uint32_t width, std::uint32_t height) {
    const auto store = [&](std::size_t at, std::uint32_t value) {
        for (int k = 0; k < 4; ++k) png[at + k] = static_cast<char>(value >> (24 - 8 * k));
    };
    store(16, width);
    store(20, height);
    store(29, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(png.data()) + 12, 17)));
    return png;
}

TEST_F(Png, RefusesMorePixelsThanItWouldWrite) {
    write_png(file_, image_);
    std::string whole = with_size(bytes(), 16384, 16384);
    whole[24] = 1;  // a bit a pixel: few bytes claim much memory
    whole[25] = 0;
    whole = with_size(whole, 16384, 16384) + std::string(200'000, '\0');
    put(whole);
    EXPECT_NE(refusal().find("too many pixels"), std::string::npos) << refusal();
}

TEST_F(Png, RefusesSizesThatItCannotHold) {
    write_png(file_, image_);
    const std::string whole = bytes();
    for (const auto& [width, height] :
         {std::pair{16384u, 16384u}, {16385u, 1u}, {0x7fffffffu, 0x7fffffffu}, {0u, 3u}}) {
        put(with_size(whole, width, height));
        EXPECT_NE(refusal(), "") << width << " × " << height;
    }
}

TEST_F(Png, SaysWhyAPathCannotBeWritten) {
    const auto reason = [&](const fs::path& path) -> std::string {
        std::string checked;
        try {
            check_writable(path);
        } catch (const std::runtime_error& error) {
            checked = error.what();
        }
        try {
            write_png(path, image_);
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(checked, error.what());
        }
        return checked;
    };
    EXPECT_NE(reason(directory_ / "none" / "a.png").find("there is no directory"), std::string::npos);
    EXPECT_NE(reason(directory_).find("directory"), std::string::npos);
    EXPECT_NE(reason("").find("no file"), std::string::npos);
    EXPECT_NE(reason("/proc/a.png"), "");
    EXPECT_NE(reason("/dev/null").find("no file"), std::string::npos);
    EXPECT_EQ(files(), 0u);
    EXPECT_EQ(reason(file_), "");
    EXPECT_EQ(files(), 1u) << "only the picture that was then written";
}

TEST_F(Png, RefusesToWriteNonsense) {
    EXPECT_THROW(write_png(file_, Image{2, 2, {1, 2, 3}}), std::runtime_error);
    EXPECT_THROW(write_png(file_, Image{}), std::runtime_error);
    EXPECT_THROW(write_png(file_, image_, std::vector<TextChunk>{{"", "x"}}), std::runtime_error);
    EXPECT_THROW(write_png(file_, image_, std::vector<TextChunk>{{std::string(80, 'k'), "x"}}),
                 std::runtime_error);
    EXPECT_THROW(write_png(file_, image_, std::vector<TextChunk>{{"k", std::string("a\0b", 3)}}),
                 std::runtime_error);
    EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace whorl
