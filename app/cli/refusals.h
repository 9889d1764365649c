// What is said of arguments that nothing takes, in Whorl's own words.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace whorl::app {

/// The first argument that nothing takes, in one line.
std::string unexpected(const CLI::App& app);

/// The first option that stands before a verb, where only the window's stand.
std::optional<std::string> misplaced(const CLI::App& app);

/// What the library says of an option with too few values or too many, which begins with its name.
std::string mismatch(const std::string& said);

/// Prints the reason and where help is. @return the exit code
int refuse(const CLI::App& app, std::string reason);

}  // namespace whorl::app
