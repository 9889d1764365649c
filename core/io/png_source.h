// Where a PNG's bytes come from: a file, or memory.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/png.h"

namespace whorl {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A stream of a PNG file that stands behind the signature.
struct PngSource {
    static constexpr int signature_bytes = 8;

    /// @throws std::runtime_error if there is no such file, it is larger than `max_png_bytes`, or no PNG
    explicit PngSource(const std::filesystem::path& path);
    /// @param bytes  outlive the source
    /// @param called  what errors call it
    PngSource(std::string_view bytes, std::string_view called);

    /// @throws std::runtime_error `cannot read NAME: REASON`
    [[noreturn]] void fail(const std::string& reason) const;

    std::string name;
    std::uintmax_t bytes = 0;  ///< of the whole file
    std::unique_ptr<std::FILE, CloseFile> file;

  private:
    void check_signature() const;
};

/// The text chunks from where the source stands, behind its signature.
std::vector<TextChunk> read_png_text(PngSource& source);

}  // namespace whorl
