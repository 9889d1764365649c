// What a person asks of files, and what is known of those in the making.
#pragma once

#include <memory>
#include <optional>
#include <string>

namespace whorl::app {

struct Lesson;

/// How a picture is made.
struct PictureOptions {
    int scale = 1;  ///< pixels to a point: 1, 2 or 4
    bool light = false;
    bool plots = false;  ///< those of the measures beneath the fields
};

/// How an animation is made.
struct FilmOptions {
    enum class Kind { Mp4, Gif, Pictures };

    Kind kind = Kind::Mp4;
    int every = 2;  ///< steps from one picture to the next
    int frames_per_second = 30;
};

/// An animation in the making.
struct FilmProgress {
    std::string name;  ///< of the file
    double seconds;    ///< since it began
};

/// Panels and keys put their requests here; FileService serves them once a frame and takes them away.
struct FileRequests {
    bool take_picture = false;
    bool save_run = false;
    bool save_plots = false;
    bool cancel_film = false;
    std::optional<FilmOptions> make_film;
    std::optional<std::string> open;       ///< a name as find_run takes it, or the path of a lesson
    std::shared_ptr<const Lesson> lesson;  ///< one that has been opened, until its panel has it
    /// What became of the last name to open: empty if it was opened, else why not.
    std::optional<std::string> open_outcome;

    PictureOptions picture;
    FilmOptions film;                     ///< as the dialog is set
    std::optional<FilmProgress> filming;  ///< shown while one is made

    // The dialogs.
    bool ask_open = false;  ///< shows the dialog from the next frame on
    bool ask_film = false;
    bool dialog = false;  ///< one is on screen: keys are not for the run
    bool enter = false;   ///< the key was pressed since the last frame, however briefly
    bool escape = false;
};

}  // namespace whorl::app
