// What is asked in a window of its own over all others.
#pragma once

#include <string>
#include <vector>

#include "app/run/file_requests.h"
#include "app/run/run_view.h"
#include "app/ui/ui.h"

namespace whorl::app {

/// A run that can be opened.
struct RunEntry {
    std::string name;   ///< as find_run takes it
    std::string title;  ///< beside it, dim
};

/// Presets, and the runs and pictures of the current folder by name.
std::vector<RunEntry> runs_here();

/// Chooses a preset or a file to open. Shows while the requests say so; draw it once a frame.
class OpenDialog {
  public:
    OpenDialog(Ui& ui, FileRequests& files) : ui_(ui), files_(files) {}

    void draw();
    /// Types a path.
    void type(std::string_view path) { path_ = path; }
    /// Why the path was not opened; empty if it was, or has not been tried.
    const std::string& error() const { return error_; }

  private:
    void choose();
    void list();
    bool has_failed();

    Ui& ui_;
    FileRequests& files_;
    std::string path_;      ///< typed
    bool opening_ = false;  ///< the path was chosen, and nothing has become of it yet
    std::string error_;
    std::vector<RunEntry> entries_;
};

/// Chooses how an animation is made.
class FilmDialog {
  public:
    FilmDialog(Ui& ui, const RunView& run, FileRequests& files) : ui_(ui), run_(run), files_(files) {}

    void draw();

  private:
    void kind_row();
    void numbers();

    Ui& ui_;
    const RunView& run_;
    FileRequests& files_;
    bool has_ffmpeg_ = false;  ///< when the dialog came up
};

/// Centres the next dialog. @param width points
bool begin_dialog(const Theme& theme, FileRequests& files, const char* title, float width);

}  // namespace whorl::app
