#include "core/io/series.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "core/io/png.h"

namespace whorl {
namespace {

/// Nine digits give a float back exactly.
std::string figure(double value) {
    if (!std::isfinite(value)) return {};
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.9g", value + 0.0);  // + 0.0: no "-0"
    return buffer;
}

}  // namespace

Series::Series(const std::filesystem::path& path, std::string_view header) : path_(path) {
    if (path == "-") {
        file_ = stdout;
    } else {
        check_writable(path);
        aside_ = path;
        aside_ += ".part";
        file_ = std::fopen(aside_.c_str(), "w");
        if (file_ == nullptr)
            throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(errno));
    }
    put(header);
}

Series::~Series() {
    if (file_ == nullptr || file_ == stdout) return;
    std::fclose(file_);
    std::error_code ignored;
    std::filesystem::remove(aside_, ignored);
}

void Series::put(std::string_view line) {
    const bool written =
        std::fwrite(line.data(), 1, line.size(), file_) == line.size() && std::fputc('\n', file_) != EOF;
    failed_ = failed_ || !written;
}

void Series::row(std::span<const double> values) {
    std::string line;
    for (std::size_t k = 0; k < values.size(); ++k) line += (k > 0 ? "," : "") + figure(values[k]);
    put(line);
}

void Series::row(std::string_view name, double value) {
    put(std::string(name) + ',' + figure(value));
}

void Series::finish() {
    if (file_ == stdout) {
        if (std::fflush(stdout) != 0 || failed_) throw std::runtime_error("standard output was closed");
        return;
    }
    errno = 0;
    failed_ = std::fclose(std::exchange(file_, nullptr)) != 0 || failed_;
    std::error_code error;
    if (!failed_) std::filesystem::rename(aside_, path_, error);
    if (failed_ || error) {
        const std::string reason = error        ? error.message()
                                   : errno != 0 ? std::strerror(errno)
                                                : "the disk is full";
        std::filesystem::remove(aside_, error);
        throw std::runtime_error("cannot write " + path_.string() + ": " + reason);
    }
}

}  // namespace whorl
