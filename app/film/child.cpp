#include "app/film/child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace whorl::app {
namespace {

constexpr off_t most_output = off_t{1} << 20;  // of a program's last words we look at, bytes

[[noreturn]] void fail(int error) {
    throw std::runtime_error(std::strerror(error));
}

/// The end of what was written to a file in memory.
std::string text_of(int descriptor) {
    const off_t size = ::lseek(descriptor, 0, SEEK_END);
    const off_t from = std::max<off_t>(0, size - most_output);
    std::string text(static_cast<std::size_t>(std::max<off_t>(0, size - from)), '\0');
    const ssize_t count = ::pread(descriptor, text.data(), text.size(), from);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
    return text;
}

/// What a program is started with.
struct Start {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;

    Start() {
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
        // Whatever we ignore or block, the program should know the usual.
        sigset_t signals;
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&attributes, &signals);
        sigaddset(&signals, SIGPIPE);
        posix_spawnattr_setsigdefault(&attributes, &signals);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    ~Start() {
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
    }
    Start(const Start&) = delete;
    Start& operator=(const Start&) = delete;
};

}  // namespace

std::string find_program(std::string_view name) {
    const char* path = std::getenv("PATH");
    std::istringstream directories(path != nullptr ? path : "");
    for (std::string directory; std::getline(directories, directory, ':');) {
        std::string program = (directory.empty() ? "." : directory) + "/" + std::string(name);
        struct stat status {};
        if (::stat(program.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
            ::access(program.c_str(), X_OK) == 0)
            return program;
    }
    return {};
}

void Child::Descriptor::close() {
    if (number >= 0) ::close(std::exchange(number, -1));
}

Child::Child(const std::vector<std::string>& command) {
    // A socket rather than a pipe: it can tell that its reader is gone without a signal to the whole process.
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail(errno);
    input_.number = ends[0];
    Descriptor theirs;
    theirs.number = ends[1];
    output_.number = ::memfd_create("output", MFD_CLOEXEC);
    error_.number = ::memfd_create("error", MFD_CLOEXEC);
    if (output_.number < 0 || error_.number < 0) fail(errno);

    Start start;
    posix_spawn_file_actions_adddup2(&start.files, theirs.number, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&start.files, output_.number, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&start.files, error_.number, STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int error =
        ::posix_spawn(&pid_, arguments[0], &start.files, &start.attributes, arguments.data(), environ);
    if (error != 0) {
        pid_ = -1;
        fail(error);
    }
}

Child::~Child() {
    if (pid_ < 0) return;
    ::kill(pid_, SIGKILL);
    wait();
}

bool Child::feed(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t taken = ::send(input_.number, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (taken < 0 && errno == EINTR) continue;
        if (taken < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(taken));
    }
    return true;
}

bool Child::running() {
    if (pid_ >= 0 && ::waitpid(pid_, &status_, WNOHANG) == pid_) pid_ = -1;
    return pid_ >= 0;
}

bool Child::wait() {
    input_.close();
    if (pid_ >= 0) {
        while (::waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
    }
    return WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

std::string Child::output() const {
    return text_of(output_.number);
}

std::string Child::reason() const {
    std::istringstream lines(text_of(error_.number));
    std::string last;
    for (std::string line; std::getline(lines, line);) {
        std::replace(line.begin(), line.end(), '\r', ' ');
        if (line.find_first_not_of(' ') != line.npos) last = line;
    }
    if (!last.empty()) return last;
    if (WIFSIGNALED(status_)) return std::string("it was stopped: ") + ::strsignal(WTERMSIG(status_));
    return "it ended with code " + std::to_string(WEXITSTATUS(status_)) + " and no word why";
}

}  // namespace whorl::app
