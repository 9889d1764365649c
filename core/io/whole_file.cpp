#include "core/io/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace whorl {
namespace {

namespace fs = std::filesystem;

fs::path directory_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Why no file can be at `path`, or nothing.
std::string objection(const fs::path& path) {
    std::error_code ignored;
    if (path.empty() || !path.has_filename()) return "this names no file";
    if (fs::is_directory(path, ignored)) return "this is a directory";
    // Renaming onto a device or a pipe would take its place.
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return "this is no file";
    if (!fs::exists(directory_of(path), ignored))
        return "there is no directory " + directory_of(path).string();
    return {};
}

std::string reason_of(int error) {
    return error == 0 ? "the disk gave no reason" : std::strerror(error);
}

}  // namespace

void cannot_write(const fs::path& path, const std::string& reason) {
    throw std::runtime_error("cannot write " + path.string() + ": " + reason);
}

WholeFile::WholeFile(const fs::path& path) : path_(path) {
    if (const std::string reason = objection(path); !reason.empty()) cannot_write(path, reason);
    static std::atomic<unsigned> count{0};
    int descriptor = -1;
    do {  // another program with our number may have left its file
        aside_ = path;
        aside_ += ".part-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
        descriptor = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EEXIST);
    if (descriptor < 0) cannot_write(path, reason_of(errno));
    file_ = ::fdopen(descriptor, "wb");
    if (file_ == nullptr) {
        ::close(descriptor);
        ::unlink(aside_.c_str());
        cannot_write(path, "out of memory");
    }
}

WholeFile::~WholeFile() {
    if (file_ != nullptr) std::fclose(file_);
    if (!aside_.empty()) ::unlink(aside_.c_str());
}

void WholeFile::write(std::string_view bytes) {
    errno = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size() && failure_.empty())
        failure_ = reason_of(errno);
}

void WholeFile::finish() {
    errno = 0;
    // A disk that is over its quota, or far away, may say so only when the bytes must be there.
    const bool stored = std::fflush(file_) == 0 && ::fsync(::fileno(file_)) == 0;
    if (!stored && failure_.empty()) failure_ = reason_of(errno);
    errno = 0;
    if (std::fclose(std::exchange(file_, nullptr)) != 0 && failure_.empty()) failure_ = reason_of(errno);
    if (failure_.empty()) failure_ = objection(path_);  // names a directory that is gone
    if (failure_.empty() && std::rename(aside_.c_str(), path_.c_str()) != 0) failure_ = reason_of(errno);
    if (!failure_.empty()) cannot_write(path_, failure_);
    aside_.clear();
}

void write_whole_file(const fs::path& path, std::string_view bytes) {
    WholeFile file(path);
    file.write(bytes);
    file.finish();
}

void check_writable(const fs::path& path) {
    const WholeFile tried(path);
}

}  // namespace whorl
