// A disk that is full, for what runs in a process of its own.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <string>

namespace whorl::test {

/// From now on no file of this process, or of those it starts, can grow beyond `bytes`.
inline void fill_disk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);  // the write fails instead
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

/// Runs `work` where no file can grow beyond `bytes`, and returns the message of what it throws, or nothing.
/// Says "it crashed" if it does not come back.
template <class Work>
std::string on_full_disk(rlim_t bytes, const Work& work) {
    int ends[2];
    if (::pipe(ends) != 0) return "no pipe";
    const pid_t child = ::fork();
    if (child == 0) {
        fill_disk(bytes);
        std::string message;
        try {
            work();
        } catch (const std::exception& e) {
            message = e.what();
        }
        const bool told =
            ::write(ends[1], message.data(), message.size()) == static_cast<ssize_t>(message.size());
        ::_exit(told ? 0 : 1);
    }
    ::close(ends[1]);
    std::string message;
    char buffer[512];
    for (ssize_t n; (n = ::read(ends[0], buffer, sizeof buffer)) > 0;)
        message.append(buffer, static_cast<std::size_t>(n));
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    return status == 0 ? message : "it crashed";
}

}  // namespace whorl::test
