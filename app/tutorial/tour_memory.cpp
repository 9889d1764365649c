#include "app/tutorial/tour_memory.h"

#include <cstdlib>
#include <stdexcept>

#include "core/io/whole_file.h"

namespace whorl::app {

namespace fs = std::filesystem;

fs::path tour_memory() {
    // The XDG specification has relative paths ignored.
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && fs::path(state).is_absolute()) return fs::path(state) / "whorl" / "tour-seen";
    const char* home = std::getenv("HOME");
    if (home == nullptr || !fs::path(home).is_absolute()) return {};
    return fs::path(home) / ".local" / "state" / "whorl" / "tour-seen";
}

bool tour_seen() {
    std::error_code unknown;
    return fs::exists(tour_memory(), unknown);
}

void remember_tour() {
    const fs::path path = tour_memory();
    if (path.empty()) throw std::runtime_error("neither XDG_STATE_HOME nor HOME is set");
    fs::create_directories(path.parent_path());
    write_whole_file(path, "");
}

}  // namespace whorl::app
