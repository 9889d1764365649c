// A progress bar for a person who waits.
#pragma once

#include <string>

namespace whorl::app {

/// Draws on standard error if that is a terminal, and is silent elsewhere.
class Progress {
  public:
    explicit Progress(std::string label, long total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void at(long done);

  private:
    std::string label_;
    long total_;
    long drawn_ = -1;
    bool terminal_;
};

}  // namespace whorl::app
