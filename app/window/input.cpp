#include "app/window/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace whorl::app {
namespace {

using Kind = InputEvent::Kind;

Input& of(GLFWwindow* window) {
    return *static_cast<Input*>(glfwGetWindowUserPointer(window));
}

}  // namespace

Input::Input(GLFWwindow* window) : window_(window) {
    glfwSetWindowUserPointer(window, this);
    install();
}

Input::~Input() {
    glfwSetWindowUserPointer(window_, nullptr);
}

void Input::install() {
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
        int wide = 0, high = 0, pixels_wide = 0, pixels_high = 0;
        glfwGetWindowSize(window, &wide, &high);
        glfwGetFramebufferSize(window, &pixels_wide, &pixels_high);
        Input& input = of(window);
        input.x_ = wide > 0 ? x * pixels_wide / wide : x;
        input.y_ = high > 0 ? y * pixels_high / high : y;
        input.collected_.push_back({.kind = Kind::Move, .x = input.x_, .y = input.y_});
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int mods) {
        Input& input = of(window);
        input.collected_.push_back({.kind = action == GLFW_PRESS ? Kind::Press : Kind::Release,
                                    .x = input.x_,
                                    .y = input.y_,
                                    .code = button,
                                    .mods = mods});
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double y) {
        const auto down = [&](int key) { return glfwGetKey(window, key) == GLFW_PRESS; };
        const bool control = down(GLFW_KEY_LEFT_CONTROL) || down(GLFW_KEY_RIGHT_CONTROL);
        Input& input = of(window);
        input.collected_.push_back({.kind = Kind::Wheel,
                                    .x = input.x_,
                                    .y = input.y_,
                                    .turn = y,
                                    .mods = control ? GLFW_MOD_CONTROL : 0});
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int mods) {
        Input& input = of(window);
        input.repeating_ = action == GLFW_REPEAT;
        input.collected_.push_back({.kind = action == GLFW_RELEASE ? Kind::KeyUp : Kind::Key,
                                    .code = key,
                                    .mods = mods,
                                    .repeated = input.repeating_});
    });
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned character) {
        Input& input = of(window);
        input.collected_.push_back(
            {.kind = Kind::Character, .code = static_cast<int>(character), .repeated = input.repeating_});
    });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        if (count > 0) of(window).collected_.push_back({.kind = Kind::Drop, .path = paths[0]});
    });
}

const std::vector<InputEvent>& Input::take() {
    taken_.swap(collected_);
    collected_.clear();
    return taken_;
}

}  // namespace whorl::app
