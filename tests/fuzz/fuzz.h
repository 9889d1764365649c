// Feeds a reader hostile input for a number of seconds, and says what it did not stand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace whorl::fuzz {

/// SplitMix64, so that a seed gives the same cases everywhere.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t operator()();
    /// 0 to n − 1; n > 0.
    std::size_t below(std::size_t n) { return static_cast<std::size_t>((*this)() % n); }
    bool one_in(std::size_t n) { return below(n) == 0; }
    template <class List>
    const auto& of(const List& list) {
        return list[below(std::size(list))];
    }

  private:
    std::uint64_t state_;
};

struct Reader {
    std::string name;
    std::vector<std::string> corpus;  ///< what is to be mutated
    /// Makes `input` hostile.
    std::function<void(std::string& input, Random&)> mutate;
    /// Reads it, and returns what is wrong with how it was refused, or nothing.
    std::function<std::string(const std::string& input)> read;
};

/// Length to which mutations grow an input at most, bytes: more than any reader of text takes.
inline constexpr std::size_t max_input = std::size_t{5} << 18;

/// Changes bytes in one of many ways: bits, pieces doubled, cut, moved or taken from `others`, words of
/// `dictionary`, once or a hundred thousand times.
void mutate_bytes(std::string& input, Random& random, std::span<const std::string> others,
                  std::span<const std::string> dictionary);

/// What input is called in errors.
inline constexpr std::string_view input_name = "input";

/// What is wrong with how `read` refuses: an exception other than `Documented`, or more than a line, or one
/// that does not name the input. Nothing if it succeeds or refuses well.
template <class Documented, class Read>
std::string complaint_about(const Read& read) {
    try {
        read();
    } catch (const Documented& e) {
        const std::string_view line = e.what();
        if (line.find('\n') != line.npos) return "the error is more than a line: " + std::string(line);
        if (line.find(input_name) == line.npos)
            return "the error does not name its input: " + std::string(line);
    } catch (const std::exception& e) {
        return std::string("an exception that is not documented: ") + e.what();
    }
    return {};
}

/// The program: `SECONDS [SEED [CASE]]`. Every case follows from seed and number alone; with CASE only that
/// one is read. @returns the exit code
int run(const Reader& reader, int argc, char** argv);

}  // namespace whorl::fuzz
