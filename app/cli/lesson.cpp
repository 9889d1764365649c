// `whorl lesson`: lists lessons, prints one, checks their claims, draws their steps.
#include <cstdio>
#include <filesystem>
#include <optional>

#include "app/cli/exit_code.h"
#include "app/cli/headless.h"
#include "app/cli/verbs.h"
#include "app/lessons/lesson_run.h"
#include "core/base/error.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

constexpr std::size_t text_width = 96;  // of a terminal, letters

/// Letters of a UTF-8 text.
std::size_t letters(std::string_view text) {
    std::size_t count = 0;
    for (const char c : text) count += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    return count;
}

/// Prints words in lines of at most text_width letters, the first after `first`, others after as many spaces.
void print_wrapped(std::string_view text, const std::string& first) {
    const std::string indent(letters(first), ' ');
    std::string line = first;
    bool begun = false;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        if (begun && letters(line) + 1 + letters(word) > text_width) {
            std::puts(line.c_str());
            line = indent;
            begun = false;
        }
        line += (begun ? " " : "") + std::string(word);
        begun = true;
    }
    std::puts(line.c_str());
}

void print_block(const Block& block) {
    std::string_view text = block.text;
    switch (block.kind) {
        case Block::Kind::Heading:
            std::printf("\n%s\n", block.text.c_str());
            break;
        case Block::Kind::Paragraph:
            std::puts("");
            print_wrapped(text, "");
            break;
        case Block::Kind::Item:
            print_wrapped(text, "  - ");
            break;
        case Block::Kind::Formula:
            std::puts("");
            while (!text.empty()) {
                const std::string_view line = text.substr(0, text.find('\n'));
                text.remove_prefix(std::min(text.size(), line.size() + 1));
                std::printf("    %.*s\n", static_cast<int>(line.size()), line.data());
            }
            break;
    }
}

void print_lesson(const Lesson& lesson) {
    std::printf("%s\n%s\n", lesson.title.c_str(), lesson.summary.c_str());
    for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
        const LessonStep& step = lesson.steps[k];
        std::printf("\n\n%zu. %s\n", k + 1, step.title.c_str());
        for (const Block& block : step.text) print_block(block);
        if (!step.tries.empty()) std::puts("\nWhat to try");
        for (const std::string& text : step.tries) print_wrapped(text, "  - ");
    }
}

void print_list() {
    for (const Lesson& lesson : lessons()) {
        std::printf("  %-12s %s\n", lesson.key.c_str(), lesson.title.c_str());
        print_wrapped(lesson.summary, std::string(15, ' '));
    }
    std::puts("\nwhorl lesson KEY prints one; --check runs its steps and measures what they claim.");
}

/// Runs a lesson's steps. @return how many claims do not hold
std::size_t run_steps(const Lesson& lesson, const LessonArguments& arguments, Pool& pool,
                      std::size_t& claims) {
    std::size_t wrong = 0;
    LessonRun run(pool);
    for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
        const LessonStep& step = lesson.steps[k];
        const std::string place = lesson.key + " " + std::to_string(k + 1);
        try {
            run.enter(step);
        } catch (const InputError& e) {
            throw std::runtime_error(place + ": " + e.what());
        }
        for (const Claim& claim : step.claims) {
            if (!arguments.check) break;
            const double value = run.measure(claim);
            const bool holds = claim.holds(value);
            const std::string line = lesson.key + ":" + std::to_string(claim.line) + ":" +
                                     std::to_string(claim.column) + ": step " + std::to_string(k + 1);
            std::printf("%s  %s: %s = %s  (%s)\n", holds ? "ok   " : "WRONG", line.c_str(),
                        describe(claim, step.recording.setup).c_str(), figure(value, 6).c_str(),
                        bounds(claim).c_str());
            wrong += holds ? 0 : 1;
            ++claims;
        }
        if (arguments.pictures.empty()) continue;
        DrawArguments draw;
        draw.view = step.view->key;
        draw.difference = step.mode == LessonMode::Difference;
        const SessionSnapshot snapshot = run.look(step);
        const std::string name = std::filesystem::path(lesson.key).stem().string();
        write_picture(arguments.pictures + "/" + name + "-" + std::to_string(k + 1) + ".png",
                      Drawing(draw).draw({&snapshot, 1}), step.recording);
    }
    return wrong;
}

}  // namespace

int run_lesson(const LessonArguments& arguments) {
    const bool all = arguments.lesson.empty();
    const bool runs = arguments.check || !arguments.pictures.empty();
    if (!runs && all) {
        print_list();
        return 0;
    }
    std::vector<Lesson> one;
    if (!all) one.push_back(find_lesson(arguments.lesson));
    const std::span<const Lesson> chosen = all ? lessons() : one;
    if (!runs) {
        print_lesson(chosen.front());
        return 0;
    }
    if (!arguments.pictures.empty() && !std::filesystem::is_directory(arguments.pictures))
        throw InputError("--pictures " + arguments.pictures + ": there is no such folder");
    Pool pool(arguments.threads);
    std::size_t claims = 0, wrong = 0;
    for (const Lesson& lesson : chosen) wrong += run_steps(lesson, arguments, pool, claims);
    if (arguments.check) std::printf("%zu of %zu claims hold\n", claims - wrong, claims);
    return wrong == 0 ? 0 : exit_failed;
}

}  // namespace whorl::app
