#include "core/io/png_source.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace whorl {

namespace fs = std::filesystem;

PngSource::PngSource(const fs::path& path) : name(path.string()) {
    std::error_code error;
    const auto status = fs::status(path, error);
    if (!fs::exists(status)) fail("there is no such file");
    if (!fs::is_regular_file(status)) fail("this is no file");
    errno = 0;
    file.reset(std::fopen(path.c_str(), "rbe"));
    if (file == nullptr) fail(std::strerror(errno));
    bytes = fs::file_size(path, error);
    check_signature();
}

PngSource::PngSource(std::string_view memory, std::string_view called) : name(called), bytes(memory.size()) {
    // A stream that is opened for reading leaves its memory as it is.
    if (!memory.empty()) file.reset(::fmemopen(const_cast<char*>(memory.data()), memory.size(), "rb"));
    check_signature();
}

void PngSource::fail(const std::string& reason) const {
    throw std::runtime_error("cannot read " + name + ": " + reason);
}

void PngSource::check_signature() const {
    constexpr std::string_view signature("\x89PNG\r\n\x1a\n", signature_bytes);
    char begin[signature_bytes] = {};
    if (file == nullptr || std::fread(begin, 1, sizeof begin, file.get()) != sizeof begin ||
        std::string_view(begin, sizeof begin) != signature) {
        fail("this is no PNG picture");
    }
    if (bytes > max_png_bytes) fail("this is larger than any picture of ours");
}

}  // namespace whorl
