// What runs without a window share: the scene as asked for, and its last step as a picture.
#pragma once

#include <memory>

#include "app/cli/arguments.h"
#include "core/session/lane.h"

namespace whorl::app {

/// Sets the parameters given by --set, and checks that the choices go together.  @throws InputError
void apply_settings(Scene& scene, const std::vector<std::string>& settings);

/// The picture of a run, as --picture, --view, --map and --range ask.
class PictureOutput {
  public:
    /// Checks before a long run that all of its files can be written, and that there is something to draw
    /// with.
    /// @throws InputError, NoOpenGl, std::runtime_error
    explicit PictureOutput(const RunArguments& arguments);
    ~PictureOutput();
    PictureOutput(const PictureOutput&) = delete;
    PictureOutput& operator=(const PictureOutput&) = delete;

    /// Draws the lane's present step, if a picture was asked for.  @throws InputError, std::runtime_error
    void write(const Lane& lane, Pool& pool);

  private:
    struct Canvas;
    const RunArguments& arguments_;
    std::unique_ptr<Canvas> canvas_;
};

/// Says on standard error that something was written, unless the run's rows go to standard output.
void say_written(const std::string& what, const std::string& file);

}  // namespace whorl::app
