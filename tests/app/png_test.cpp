// PNG files: what is written is read, and what is no picture is refused.
#include "core/io/png.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <zlib.h>
#include <fstream>
#include <iterator>

namespace whorl {
namespace {

namespace fs = std::filesystem;

class Png : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "whorl-png-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        directory_ = name;
        file_ = directory_ / "picture.png";
        for (int k = 0; k < 5 * 3 * 4; ++k) image_.rgba.push_back(static_cast<std::uint8_t>(k * 37));
    }
    void TearDown() override { fs::remove_all(directory_); }

    std::string bytes() const {
        std::ifstream in(file_, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void put(const std::string& text) const { std::ofstream(file_, std::ios::binary) << text; }
    std::string refusal() const {
        try {
            read_png(file_);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    }
    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), {}));
    }

    fs::path directory_;
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

TEST_F(Png, CheckLeavesAFileAlone) {
    put("precious");
    check_writable(file_);
    EXPECT_EQ(bytes(), "precious");
    EXPECT_EQ(files(), 1u);
}

TEST_F(Png, RefusesToWriteNonsense) {
    EXPECT_THROW(write_png(file_, Image{2, 2, {1, 2, 3}}), std::runtime_error);
    EXPECT_THROW(write_png(file_, Image{}), std::runtime_error);
    EXPECT_THROW(write_png(file_, image_, std::vector<TextChunk>{{"", "x"}}), std::runtime_error);
    EXPECT_THROW(write_png(file_, image_, std::vector<TextChunk>{{std::string(80, 'k'), "x"}}),
                 std::runtime_error);
    EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace whorl
