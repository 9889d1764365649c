#include "core/io/series.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace whorl {
namespace {

/// Nine digits give a float back exactly.
std::string figure(double value) {
    if (!std::isfinite(value)) return {};
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.9g", value + 0.0);  // + 0.0: no "-0"
    return buffer;
}

/// A text as a field of CSV: in quotes where it holds what ends one.
std::string field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

}  // namespace

Series::Series(const std::filesystem::path& path, std::string_view header) {
    if (path != "-") file_.emplace(path);
    put(std::string(header));
}

void Series::put(std::string line) {
    line += '\n';
    if (file_) {
        file_->write(line);
    } else {
        closed_ = std::fwrite(line.data(), 1, line.size(), stdout) != line.size() || closed_;
    }
}

void Series::row(std::span<const double> values) {
    row({}, values);
}

void Series::row(std::initializer_list<std::string_view> names, std::span<const double> values) {
    std::string line;
    bool first = true;
    const auto add = [&](const std::string& text) {
        line += (std::exchange(first, false) ? "" : ",") + text;
    };
    for (const std::string_view name : names) add(field(name));
    for (const double value : values) add(figure(value));
    put(std::move(line));
}

void Series::finish() {
    if (file_) {
        file_->finish();
    } else if (std::fflush(stdout) != 0 || closed_) {
        throw std::runtime_error("standard output was closed");
    }
}

}  // namespace whorl
