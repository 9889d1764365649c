// Lessons: texts in steps, each with the run and the view that it speaks of.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/lessons/claim.h"
#include "app/lessons/markup.h"
#include "app/views/views.h"
#include "core/session/recording.h"

namespace whorl::app {

/// How a step shows its lanes.
enum class LessonMode { SideBySide, One, Wipe, Difference };

struct LessonStep {
    std::string title;
    std::vector<Block> text;
    std::vector<std::string> tries;  ///< what a student may try, none to several
    std::string scene;               ///< as find_run takes it
    Recording recording;             ///< scene, lanes, and the step of the run that is looked at
    const View* view = nullptr;
    LessonMode mode = LessonMode::SideBySide;
    std::vector<Claim> claims;  ///< what the text says in numbers
};

struct Lesson {
    std::string key;  ///< or the file's path
    std::string title, summary;
    std::vector<LessonStep> steps;  ///< at least one
};

/// Reads a lesson. What a step does not give stays as in the step before; a step that names a scene begins
/// with that alone. docs/lessons.md describes the format.
/// @param name  what errors call the text
/// @throws InputError with `name:line:column: reason`
Lesson parse_lesson(std::string_view text, std::string_view name);

/// The lessons that come with the program, in the order in which they are best read.
std::span<const Lesson> lessons();

/// The lesson called `name`: a key, or where the name ends in .toml or has a slash, a file.
/// @throws InputError that names the nearest keys, or what is wrong in the file
Lesson find_lesson(std::string_view name);

}  // namespace whorl::app
