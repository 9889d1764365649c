#include "app/window/film_maker.h"

#include <stdlib.h>

#include <chrono>

#include "app/film/child.h"
#include "app/film/film.h"
#include "app/window/numbered_path.h"
#include "core/io/run_file.h"
#include "core/io/whole_file.h"

namespace whorl::app {
namespace {

namespace fs = std::filesystem;

/// A folder that is gone with all that is in it when it is left.
class Workshop {
  public:
    explicit Workshop(const fs::path& beside) {
        std::string name = (beside / ".whorl-film-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            cannot_write(name, std::error_code(errno, std::generic_category()).message());
        path_ = name;
    }
    ~Workshop() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

std::string ending(FilmOptions::Kind kind) {
    using Kind = FilmOptions::Kind;
    return kind == Kind::Mp4 ? ".mp4" : kind == Kind::Gif ? ".gif" : "-frames";
}

/// Waits for the program.  @return whether it was not stopped before
bool finished(Child& child, const std::stop_token& stop) {
    while (child.running()) {
        if (stop.stop_requested()) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
    return true;
}

/// @return where the film is; nothing if it was cancelled
std::string make(const fs::path& program, const Recording& recording, const FilmOptions& options,
                 const std::stop_token& stop) {
    const fs::path target = numbered_path(ending(options.kind));
    const Workshop workshop(target.parent_path());
    const fs::path run = workshop.path() / "run.toml";
    write_whole_file(run, write_run(recording));
    const fs::path made = workshop.path() / target.filename();
    fs::path film = made;
    if (options.kind == FilmOptions::Kind::Pictures) {
        fs::create_directory(made);
        film = made / "%04d.png";
    }
    {
        const Film trial(film, options.frames_per_second);  // throws what is known to be missing
    }
    // The window comes first.
    std::vector<std::string> command;
    if (const std::string nice = find_program("nice"); !nice.empty()) command = {nice, "-n", "10"};
    for (const std::string& word :
         {fs::canonical(program).string(), std::string("run"), run.string(), std::string("--animate"),
          film.string(), std::string("--every"), std::to_string(options.every), std::string("--fps"),
          std::to_string(options.frames_per_second)})
        command.push_back(word);
    Child child(command);
    if (!finished(child, stop)) return {};
    if (!child.wait()) throw std::runtime_error(child.reason());
    fs::rename(made, target);
    return target.string();
}

}  // namespace

void FilmMaker::start(Recording recording, const FilmOptions& options, double now) {
    name_ = options.kind == FilmOptions::Kind::Pictures ? "pictures" : ending(options.kind).substr(1);
    since_ = now;
    thread_ = std::jthread([this, recording = std::move(recording), options](const std::stop_token& stop) {
        Outcome outcome;
        try {
            outcome.path = make(program_, recording, options, stop);
            outcome.cancelled = outcome.path.empty();
        } catch (const std::exception& e) {
            outcome.error = e.what();
        }
        const std::lock_guard lock(mutex_);
        outcome_ = std::move(outcome);
    });
}

std::optional<FilmProgress> FilmMaker::progress(double now) const {
    if (!busy()) return {};
    return FilmProgress{name_, now - since_};
}

std::optional<FilmMaker::Outcome> FilmMaker::take_outcome() {
    if (!busy()) return {};
    {
        const std::lock_guard lock(mutex_);
        if (!outcome_) return {};
    }
    thread_.join();
    return std::exchange(outcome_, std::nullopt);
}

}  // namespace whorl::app
