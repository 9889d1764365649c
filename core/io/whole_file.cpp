#include "core/io/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iterator>
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

/// Names of unfinished files where a signal's handler may read them. A place is taken by one thread, then
/// filled, then seen by the handler.
struct Unfinished {
    enum State { Free, Taken, Filled };
    std::atomic<int> state{Free};
    char name[4096];
};
Unfinished unfinished[64];
static_assert(std::atomic<int>::is_always_lock_free);

/// @return the place, or one past the last where none is free
std::size_t note(const fs::path& aside) {
    const std::string name = fs::absolute(aside).native();  // the program may be somewhere else by then
    for (std::size_t k = 0; k < std::size(unfinished); ++k) {
        Unfinished& place = unfinished[k];
        int free = Unfinished::Free;
        if (name.size() >= sizeof place.name) break;
        if (!place.state.compare_exchange_strong(free, Unfinished::Taken)) continue;
        std::strcpy(place.name, name.c_str());
        place.state = Unfinished::Filled;
        return k;
    }
    return std::size(unfinished);
}

void forget(std::size_t slot) {
    if (slot < std::size(unfinished)) unfinished[slot].state = Unfinished::Free;
}

extern "C" void end_without_leavings(int signal) {
    for (const Unfinished& file : unfinished) {
        if (file.state == Unfinished::Filled) ::unlink(file.name);
    }
    ::signal(signal, SIG_DFL);
    ::raise(signal);
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
    slot_ = note(aside_);
    file_ = ::fdopen(descriptor, "wb");
    if (file_ == nullptr) {
        ::close(descriptor);
        ::unlink(aside_.c_str());
        forget(slot_);
        cannot_write(path, "out of memory");
    }
}

WholeFile::~WholeFile() {
    if (file_ != nullptr) std::fclose(file_);
    if (aside_.empty()) return;
    ::unlink(aside_.c_str());
    forget(slot_);
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
    forget(slot_);
    aside_.clear();
}

void take_unfinished_files_along() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        if (::signal(signal, end_without_leavings) == SIG_IGN) ::signal(signal, SIG_IGN);  // nohup
    }
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
