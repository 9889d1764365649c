#include "app/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace whorl::app {
namespace {

constexpr long cells = 40;

}  // namespace

Progress::Progress(std::string label, long total)
    : label_(std::move(label)), total_(std::max(total, 1L)), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (terminal_ && drawn_ >= 0) std::fputs("\r\033[K", stderr);
}

void Progress::at(long done) {
    if (!terminal_) return;
    const long permille = done * 1000 / total_;
    if (permille == drawn_) return;
    drawn_ = permille;
    const long full = done * cells / total_;
    std::string bar;
    for (long k = 0; k < cells; ++k) bar += k < full ? "━" : "─";
    std::fprintf(stderr, "\r%s %s %ld/%ld", label_.c_str(), bar.c_str(), done, total_);
    std::fflush(stderr);
}

}  // namespace whorl::app
