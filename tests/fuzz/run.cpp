// The program around a reader: a process that reads, and one that watches it.
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>
#include <thread>

#include "tests/fuzz/fuzz.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

// A single block beyond this is a finding; freed memory is kept for a while, but not so long that it counts.
extern "C" const char* __asan_default_options();
const char* __asan_default_options() {
    return "max_allocation_size_mb=512:quarantine_size_mb=64";
}

namespace whorl::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

/// A case that takes longer hangs: the slowest of them take a second in a slow build.
constexpr std::chrono::seconds max_time{5};
/// Memory of the process: the largest picture, 256 MiB, and the most text while it grows, 192 MiB, with room
/// for the program and for what a sanitizer adds.
constexpr std::size_t max_memory = std::size_t{640} << 20;
constexpr std::chrono::milliseconds glance{20};

/// What the two processes know of each other.
struct Progress {
    std::atomic<std::uint64_t> number{0};  // of the case that is being read
    std::atomic<std::int64_t> began{0};    // when, in the clock's own unit; 0 between two cases
    std::atomic<std::int64_t> slowest{0};  // time, in the same unit
    std::atomic<std::uint64_t> slowest_number{0};
};

std::string input_of(const Reader& reader, std::uint64_t seed, std::uint64_t number) {
    Random random(seed * 0x100000001b3u + number);
    std::string input = random.of(reader.corpus);
    for (std::size_t k = random.below(6) + 1; k > 0; --k) reader.mutate(input, random);
    return input;
}

[[noreturn]] void read_cases(const Reader& reader, std::uint64_t seed, Clock::time_point end,
                             Progress& progress) {
    if (!sanitized) {  // sanitizers reserve terabytes
        const rlimit limit{max_memory, max_memory};
        ::setrlimit(RLIMIT_AS, &limit);
    }
    for (std::uint64_t number = progress.number; Clock::now() < end; ++number) {
        const std::string input = input_of(reader, seed, number);
        const Clock::time_point began = Clock::now();
        progress.began = began.time_since_epoch().count();
        progress.number = number;
        const std::string complaint = reader.read(input);
        const std::int64_t taken = (Clock::now() - began).count();
        progress.began = 0;
        if (taken > progress.slowest) {
            progress.slowest = taken;
            progress.slowest_number = number;
        }
        if (!complaint.empty()) {
            std::fprintf(stderr, "%s\n", complaint.c_str());
            ::_exit(1);
        }
    }
    ::_exit(0);
}

/// Of a process, bytes.
std::size_t resident_memory(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/statm");
    std::size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Waits for the process to end.  @returns what it did wrong, or nothing
std::string watch(pid_t process, const Progress& progress) {
    for (;;) {
        int status = 0;
        if (::waitpid(process, &status, WNOHANG) == process) {
            if (WIFSIGNALED(status)) return std::string("crashed: ") + ::strsignal(WTERMSIG(status));
            return WEXITSTATUS(status) == 0 ? "" : "failed";
        }
        const std::int64_t began = progress.began;
        const auto age = Clock::now().time_since_epoch() - Clock::duration(began);
        const char* wrong = began != 0 && age > max_time            ? "took more than 5 s"
                            : resident_memory(process) > max_memory ? "took more than 640 MiB"
                                                                    : nullptr;
        if (wrong != nullptr) {
            ::kill(process, SIGKILL);
            ::waitpid(process, &status, 0);
            return wrong;
        }
        std::this_thread::sleep_for(glance);
    }
}

}  // namespace

int run(const Reader& reader, int argc, char** argv) {
    const double seconds = argc > 1 ? std::strtod(argv[1], nullptr) : 30;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    if (argc > 3) {
        const std::string complaint =
            reader.read(input_of(reader, seed, std::strtoull(argv[3], nullptr, 10)));
        std::printf("%s\n", complaint.empty() ? "all is well" : complaint.c_str());
        return complaint.empty() ? 0 : 1;
    }
    std::printf("%s: seed %llu, %g s\n", reader.name.c_str(), static_cast<unsigned long long>(seed), seconds);
    std::fflush(stdout);

    void* shared =
        ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) return 1;
    auto& progress = *new (shared) Progress;
    const auto end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    const pid_t process = ::fork();
    if (process < 0) return 1;
    if (process == 0) read_cases(reader, seed, end, progress);
    const std::string wrong = watch(process, progress);

    const auto ms =
        std::chrono::duration<double, std::milli>(Clock::duration(progress.slowest.load())).count();
    std::printf("%llu cases; the slowest, %llu, took %.0f ms\n",
                static_cast<unsigned long long>(progress.number + 1),
                static_cast<unsigned long long>(progress.slowest_number.load()), ms);
    if (wrong.empty()) return 0;
    const std::uint64_t number = progress.number;
    const std::string file =
        "fuzz-" + reader.name + "-" + std::to_string(seed) + "-" + std::to_string(number) + ".bin";
    std::ofstream(file, std::ios::binary) << input_of(reader, seed, number);
    std::printf("case %llu %s; again: %s 0 %llu %llu; its input: %s\n",
                static_cast<unsigned long long>(number), wrong.c_str(), argv[0],
                static_cast<unsigned long long>(seed), static_cast<unsigned long long>(number), file.c_str());
    return 1;
}

}  // namespace whorl::fuzz
