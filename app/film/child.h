// Another program, fed through its standard input.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace whorl::app {

/// The executable of this name in PATH, or nothing.
std::string find_program(std::string_view name);

/// A running program. What it writes is kept in memory, so that it never waits for us to read.
class Child {
  public:
    /// Starts a program without a shell.
    /// @param command  path of the program, and its arguments
    /// @throws std::runtime_error with the reason
    explicit Child(const std::vector<std::string>& command);
    /// Kills the program if it still runs.
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Gives the program input; waits until it has taken it.  @returns false if it takes no more
    bool feed(std::span<const std::uint8_t> bytes);
    /// Whether the program has not ended yet; does not wait.
    bool running();
    /// Ends the input and waits for the program to end.  @returns whether it says that all is well
    bool wait();
    /// What the program wrote to its standard output; after `wait`.
    std::string output() const;
    /// Why the program failed: the last line of its standard error, else how it ended; after `wait`.
    std::string reason() const;

  private:
    /// A file descriptor that is closed.
    struct Descriptor {
        ~Descriptor() { close(); }
        void close();
        int number = -1;
    };

    Descriptor input_, output_, error_;
    pid_t pid_ = -1;
    int status_ = 0;  // as waitpid gives it
};

}  // namespace whorl::app
