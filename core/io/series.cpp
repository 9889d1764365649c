#include "core/io/series.h"

#include <cstdio>
#include <stdexcept>
#include <utility>

#include "core/base/csv.h"

namespace whorl {
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
    for (const std::string_view name : names) add(csv_text(name));
    for (const double value : values) add(csv_number(value));
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
