// The next free name of a file in the current folder.
#pragma once

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace whorl::app {

/// The first of whorl-0001, whorl-0002 … with this ending that is free, as an absolute path.
/// @throws std::runtime_error if the folder has gone
inline std::filesystem::path numbered_path(std::string_view ending) {
    namespace fs = std::filesystem;
    std::error_code gone;
    const fs::path folder = fs::current_path(gone);
    if (gone || !fs::exists(folder, gone)) throw std::runtime_error("the current folder has gone");
    for (int k = 1;; ++k) {
        char number[32];
        std::snprintf(number, sizeof number, "whorl-%04d", k);
        fs::path path = folder / (number + std::string(ending));
        std::error_code ignored;
        if (!fs::exists(path, ignored)) return path;
    }
}

}  // namespace whorl::app
