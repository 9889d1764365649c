// Files that appear whole or not at all.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace whorl {

/// A file that is written aside, in the same directory, and takes its name when it is complete. An existing
/// file of that name stays as it is until then, and for good if anything fails. All errors are
/// std::runtime_error with one line: `cannot write PATH: REASON`.
class WholeFile {
  public:
    /// @throws std::runtime_error if no file can be made at `path`
    explicit WholeFile(const std::filesystem::path& path);
    /// Takes the unfinished file away.
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// Appends; what fails is kept and thrown by `finish`, so that a long run is not stopped by its log.
    void write(std::string_view bytes);
    /// What has failed so far, or nothing. Bytes are held in a buffer: a full disk may show later.
    const std::string& failure() const { return failure_; }

    /// For libraries that write to a stream.
    std::FILE* stream() { return file_; }
    /// Where the file is until it is complete, for programs that write to a name.
    const std::filesystem::path& aside() const { return aside_; }

    /// Brings all bytes to the disk and gives the file its name.  @throws std::runtime_error; nothing is left
    void finish();

  private:
    std::filesystem::path path_, aside_;
    std::size_t slot_;  ///< where a signal finds aside_
    std::FILE* file_ = nullptr;
    std::string failure_;
};

/// From now on a signal that ends the program (SIGINT, SIGTERM, SIGHUP) takes unfinished files away first.
void take_unfinished_files_along();

/// A whole file at once.  @throws std::runtime_error as WholeFile
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

/// Asks, before a long run, whether a file could be written at `path`; leaves nothing behind and an existing
/// file as it is.  @throws std::runtime_error as WholeFile
void check_writable(const std::filesystem::path& path);

/// @throws std::runtime_error `cannot write PATH: REASON`
[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& reason);

}  // namespace whorl
