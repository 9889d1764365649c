// Rows of numbers as CSV, to a file or to standard output.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>

#include "core/io/whole_file.h"

namespace whorl {

/// A table that is written as it grows, to a file that appears when it is complete, so that no file is ever
/// half a table. `-` writes to standard output.
class Series {
  public:
    /// @throws std::runtime_error with one line that names the file and the reason if it cannot be written
    Series(const std::filesystem::path& path, std::string_view header);

    /// One row; numbers that are not finite leave their column empty.
    void row(std::span<const double> values);
    /// One that begins with names.
    void row(std::initializer_list<std::string_view> names, std::span<const double> values);
    /// Completes the file.  @throws std::runtime_error as the constructor; the file is then not there
    void finish();

  private:
    void put(std::string line);

    std::optional<WholeFile> file_;  // nothing: standard output
    bool closed_ = false;            // standard output's reader has gone
};

}  // namespace whorl
