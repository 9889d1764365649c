// An animation of a run, made by the same program without a window.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/run/file_requests.h"
#include "core/session/recording.h"

namespace whorl::app {

/// Runs `whorl run` beside the window, at a lower priority, one animation at a time. All is made in a folder
/// of its own beside the target and takes its name when it is complete; whatever breaks it off, nothing is
/// left.
class FilmMaker {
  public:
    struct Outcome {
        std::string path;
        std::string error;  ///< empty if all went well
        bool cancelled = false;
    };

    /// @param program  that takes `run FILE --animate OUT --every N --fps F`
    explicit FilmMaker(std::filesystem::path program = "/proc/self/exe") : program_(std::move(program)) {}

    /// @param now  seconds of the window's clock  @pre !busy()
    void start(Recording recording, const FilmOptions& options, double now);
    bool busy() const { return thread_.joinable(); }
    void cancel() { thread_.request_stop(); }
    /// While one is made.
    std::optional<FilmProgress> progress(double now) const;
    /// What became of it, once.
    std::optional<Outcome> take_outcome();

  private:
    std::filesystem::path program_;
    std::string name_;
    double since_ = 0;
    std::mutex mutex_;
    std::optional<Outcome> outcome_;
    std::jthread thread_;  ///< last: it ends before what it uses, and ends the program it waits for
};

}  // namespace whorl::app
