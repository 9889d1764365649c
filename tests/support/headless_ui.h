// ImGui frames without a window, for tests of what draws with ImGui.
#pragma once

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "app/render/egl_context.h"
#include "app/render/framebuffer.h"
#include "app/render/theme.h"

namespace whorl::app {

/// An OpenGL context, an ImGui context and a framebuffer of `width × height` pixels.
class HeadlessUi {
  public:
    HeadlessUi(int width, int height, float scale) : target_(width, height) {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().KeyMap[ImGuiKey_Space] = 32;  // open lists are navigated by keys, which asks for it
        ImGui_ImplOpenGL3_Init("#version 330 core");
        theme = load_theme(scale);
        ImGui::GetIO().DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    }
    ~HeadlessUi() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui::DestroyContext();
    }
    HeadlessUi(const HeadlessUi&) = delete;
    HeadlessUi& operator=(const HeadlessUi&) = delete;

    /// Draws one frame: `draw` inside a window that fills the framebuffer.
    template <class Draw>
    void frame(Draw&& draw) {
        frame_of_windows([&] {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
            ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
            draw();
            ImGui::End();
        });
    }
    /// Draws one frame: `draw` makes the windows.
    template <class Draw>
    void frame_of_windows(Draw&& draw) {
        ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        draw();
        ImGui::Render();
        target_.bind();
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }
    Image picture() const { return target_.read(); }

    Theme theme;

  private:
    EglContext context_;
    Framebuffer target_;
};

}  // namespace whorl::app
