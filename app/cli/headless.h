// What runs without a window share: the run as asked for, and its steps as pictures.
#pragma once

#include <memory>

#include "app/cli/arguments.h"
#include "app/figure/picture.h"
#include "app/views/views.h"
#include "core/session/snapshot.h"

namespace whorl::app {

/// Sets the parameters given by --set, and checks that the choices go together.  @throws InputError
void apply_settings(Scene& scene, const std::vector<std::string>& settings);

/// The scene of an experiment, or of a file.  @throws InputError
Scene experiment_scene(const std::string& name);

/// The run called `scene`, with other lanes if any are named, and with parameters set at its start.
/// @throws InputError
Recording recording_for(const std::string& scene, const std::string& lanes,
                        const std::vector<std::string>& settings);

/// Checks the name of a picture and that it can be written.  @throws InputError, std::runtime_error
void check_picture(const std::string& option, const std::string& file);

/// Draws snapshots, as --view, --map and --range ask.
class Drawing {
  public:
    /// Checks before a long run that there is something to draw with.  @throws InputError, NoOpenGl
    explicit Drawing(const DrawArguments& arguments);
    ~Drawing();
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    /// A row a snapshot.
    /// @param range  of the colours where the arguments give none; nothing for all that occur
    /// @throws InputError if a lane has no such field, std::runtime_error if the driver draws no picture so
    /// large
    Image draw(std::span<const SessionSnapshot> rows, std::optional<Range> range = {});
    /// What all lanes span of what is drawn.
    Range span(const SessionSnapshot& snapshot) const;

  private:
    struct Canvas;
    const DrawArguments& arguments_;
    std::unique_ptr<Canvas> canvas_;
};

/// Writes a picture that carries its run.
void write_picture(const std::string& file, const Image& image, const Recording& recording);

/// Says on standard error that something was written, unless the run's rows go to standard output.
void say_written(const std::string& what, const std::string& file);

}  // namespace whorl::app
