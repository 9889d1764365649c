// Rows of numbers as CSV, to a file or to standard output.
#pragma once

#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace whorl {

/// A table that is written as it grows: aside, and renamed when it is complete, so that no file is ever half
/// a table. `-` writes to standard output.
class Series {
  public:
    /// @throws std::runtime_error with one line that names the file and the reason if it cannot be written
    Series(const std::filesystem::path& path, std::string_view header);
    /// Takes the unfinished file away.
    ~Series();
    Series(const Series&) = delete;
    Series& operator=(const Series&) = delete;

    /// One row; numbers that are not finite leave their column empty.
    void row(std::span<const double> values);
    void row(std::string_view name, double value);
    /// Completes the file.  @throws std::runtime_error as the constructor; the file is then not there
    void finish();

  private:
    void put(std::string_view line);

    std::filesystem::path path_, aside_;
    std::FILE* file_ = nullptr;
    bool failed_ = false;
};

}  // namespace whorl
