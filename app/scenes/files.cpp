#include "app/scenes/files.h"

#include "core/base/error.h"
#include "core/io/png.h"
#include "core/io/run_file.h"

namespace whorl::app {

bool names_file(std::string_view name) {
    return name.ends_with(".toml") || name.ends_with(".png") || name.find('/') != std::string_view::npos;
}

bool is_lesson(std::string_view text) {
    constexpr std::string_view step = "[[step";
    return text.starts_with(step) || text.find("\n" + std::string(step)) != std::string_view::npos;
}

std::string run_text(std::string_view path) {
    if (!path.ends_with(".png")) return read_run_text(path);
    std::vector<TextChunk> chunks;
    try {
        chunks = read_png_text(path);
    } catch (const std::runtime_error& e) {
        throw InputError(e.what());
    }
    for (auto& [key, text] : chunks) {
        if (key == run_chunk) return std::move(text);
    }
    throw InputError(std::string(path) + ": this picture carries no run of Whorl");
}

}  // namespace whorl::app
