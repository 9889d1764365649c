// Which names are files, and the text of a run in them.
#pragma once

#include <string>
#include <string_view>

namespace whorl::app {

/// Whether a name means a file rather than a key: it ends in .toml or .png, or has a slash.
bool names_file(std::string_view name);

/// Whether the text is a lesson's: it has steps, which no scene or run has.
bool is_lesson(std::string_view text);

/// The run's text of a TOML file or of a Whorl picture.  @throws InputError if there is none
std::string run_text(std::string_view path);

}  // namespace whorl::app
