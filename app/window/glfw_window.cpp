#include "app/window/glfw_window.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

namespace whorl::app {
namespace {

constexpr int usual_width = 1600, usual_height = 1000;  // points
constexpr int least_width = 900, least_height = 600;

std::string last_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? std::string(": ") + text : std::string();
}

/// Room for windows on the screen.
std::pair<int, int> screen_size() {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    int x = 0, y = 0, width = 0, height = 0;
    if (monitor != nullptr) glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
    return width > 0 && height > 0 ? std::pair{width, height} : std::pair{usual_width, usual_height};
}

}  // namespace

GlfwWindow::Glfw::Glfw() {
    if (glfwInit() != GLFW_TRUE) {
        throw NoWindow("no window: there is no display" + last_error() + "; `whorl run` works without one");
    }
}

GlfwWindow::Glfw::~Glfw() {
    glfwTerminate();
}

GlfwWindow::GlfwWindow(const WindowOptions& options) : forced_scale_(options.content_scale) {
    open(options.width, options.height);
    glfwMakeContextCurrent(window_);
    if (epoxy_gl_version() < 33) {
        glfwDestroyWindow(window_);
        throw NoWindow("no window: this display gives no OpenGL 3.3");
    }
    glfwSwapInterval(1);
    input_ = std::make_unique<Input>(window_);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().LogFilename = nullptr;
    ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    theme_ = load_theme(static_cast<float>(screen_scale()));
    limit_size();
    glfwShowWindow(window_);
}

GlfwWindow::~GlfwWindow() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    input_.reset();
    glfwDestroyWindow(window_);
}

void GlfwWindow::open(int width, int height) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    float scale = static_cast<float>(forced_scale_);
    if (scale <= 0) {
        float vertical = 1;
        scale = 1;
        if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
            glfwGetMonitorContentScale(monitor, &scale, &vertical);
        }
    }
    const auto [most_wide, most_high] = screen_size();
    if (width <= 0 || height <= 0) {
        width = std::min(most_wide, static_cast<int>(usual_width * scale));
        height = std::min(most_high, static_cast<int>(usual_height * scale));
    }
    window_ = glfwCreateWindow(width, height, "Whorl", nullptr, nullptr);
    if (window_ == nullptr) throw NoWindow("no window: this display gives no OpenGL 3.3" + last_error());
}

double GlfwWindow::screen_scale() const {
    if (forced_scale_ > 0) return forced_scale_;
    float across = 1, down = 1;
    glfwGetWindowContentScale(window_, &across, &down);
    return std::clamp(static_cast<double>(across), 0.5, 4.0);
}

void GlfwWindow::limit_size() {
    const auto [most_wide, most_high] = screen_size();
    const auto scaled = [&](int points, int most) {
        return std::min(most, static_cast<int>(std::lround(points * static_cast<double>(theme_.scale))));
    };
    glfwSetWindowSizeLimits(window_, scaled(least_width, most_wide), scaled(least_height, most_high),
                            GLFW_DONT_CARE, GLFW_DONT_CARE);
}

bool GlfwWindow::closing() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void GlfwWindow::hide() {
    glfwHideWindow(window_);
    glfwPollEvents();  // sends the request
}

void GlfwWindow::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void GlfwWindow::await_events(double seconds) {
    glfwWaitEventsTimeout(seconds);
}

const std::vector<InputEvent>& GlfwWindow::begin_frame() {
    glfwPollEvents();
    glfwGetFramebufferSize(window_, &width_, &height_);
    const auto scale = static_cast<float>(screen_scale());
    if (scale != theme_.scale) {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        theme_ = load_theme(scale);
        ImGui_ImplOpenGL3_CreateFontsTexture();
        limit_size();
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    return input_->take();
}

void GlfwWindow::end_frame() {
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
}

}  // namespace whorl::app
