// The program as a person types it, in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace whorl {

namespace fs = std::filesystem;

struct Outcome {
    int code;
    std::string out;  ///< standard output and standard error
    std::size_t lines() const { return static_cast<std::size_t>(std::count(out.begin(), out.end(), '\n')); }
};

class CommandLine : public testing::Test {
  protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("whorl-cli-" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override {
        fs::permissions(folder, fs::perms::owner_all);
        fs::remove_all(folder);
    }

    Outcome whorl(const std::string& arguments) const {
        const std::string command =
            "cd '" + folder.string() + "' && env -u DISPLAY '" WHORL_BINARY "' " + arguments + " 2>&1";
        std::FILE* pipe = ::popen(command.c_str(), "r");
        Outcome outcome{};
        std::array<char, 4096> buffer;
        while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
            outcome.out.append(buffer.data(), n);
        const int status = ::pclose(pipe);
        outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return outcome;
    }
    std::string contents(const std::string& file) const {
        std::ifstream stream(folder / file);
        std::ostringstream text;
        text << stream.rdbuf();
        return text.str();
    }
    void write(const std::string& file, const std::string& text) const {
        std::ofstream(folder / file) << text;
    }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }

    fs::path folder;
};

/// Refused in one line that says both what was wrong and what would be right.
inline void expect_refused(const Outcome& o, const std::string& reason) {
    EXPECT_EQ(o.code, 2) << o.out;
    EXPECT_EQ(o.lines(), 1u) << o.out;
    EXPECT_NE(o.out.find(reason), std::string::npos) << o.out;
}

}  // namespace whorl
