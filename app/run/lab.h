// A window over the fields in which one idea can be tried.
#pragma once

#include <memory>
#include <string_view>

#include "app/run/services.h"

namespace whorl::app {

class Lab {
  public:
    virtual ~Lab() = default;
    /// Fills the current ImGui window.
    virtual void draw() = 0;
    virtual bool& open() { return open_; }

  private:
    bool open_ = false;
};

/// What its chip says, where its window lies, and how it is made.
struct LabEntry {
    std::string_view key;
    const char* label;
    std::string_view help, source;
    float width, height;  ///< at first, points; of no use where it takes a column's
    /// Where it lies at first: over the middle of the screen, at its lower edge, or over a whole column: that
    /// of the measures, or of the controls while a lesson is read.
    enum class Anchor { Middle, Bottom, Side } anchor;
    std::unique_ptr<Lab> (*make)(const Services&);
};

}  // namespace whorl::app
