#include "app/lessons/lesson.h"

#include "app/scenes/files.h"
#include "core/base/error.h"
#include "core/base/suggest.h"
#include "lesson_texts.h"  // made by CMake from app/lessons/*.toml

namespace whorl::app {

std::span<const Lesson> lessons() {
    static const std::vector<Lesson> table = [] {
        const std::pair<std::string_view, std::string_view> texts[] = {
            {"advection", lesson_texts::advection_toml},    //
            {"smear", lesson_texts::smear_toml},            //
            {"cubic", lesson_texts::cubic_toml},            //
            {"monotone", lesson_texts::monotone_toml},      //
            {"correctors", lesson_texts::correctors_toml},  //
            {"aslam", lesson_texts::aslam_toml},            //
            {"square", lesson_texts::square_toml},          //
            {"energy", lesson_texts::energy_toml},          //
        };
        std::vector<Lesson> all;
        for (const auto& [key, text] : texts) all.push_back(parse_lesson(text, key));
        return all;
    }();
    return table;
}

Lesson find_lesson(std::string_view name) {
    if (names_file(name)) return parse_lesson(run_text(name), name);
    std::vector<std::string_view> keys;
    for (const Lesson& lesson : lessons()) {
        if (lesson.key == name) return lesson;
        keys.push_back(lesson.key);
    }
    throw InputError("unknown lesson \"" + std::string(name) + "\"; " + suggestion(name, keys));
}

}  // namespace whorl::app
