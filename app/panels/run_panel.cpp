// Transport, timeline, files, scene and pace.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/list.h"
#include "app/panels/timeline.h"
#include "app/run/file_requests.h"
#include "app/run/run_control.h"
#include "app/scenes/presets.h"
#include "app/ui/ui.h"
#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

bool is_preset(std::string_view key) {
    return std::any_of(presets().begin(), presets().end(), [&](const Preset& p) { return p.key == key; });
}

class RunPanel final : public Panel {
  public:
    RunPanel(Ui& ui, RunControl& run, FileRequests& files) : ui_(ui), run_(run), files_(files) {}

    void draw() override {
        transport();
        draw_timeline(ui_, run_);
        files();
        scenes();
        pace();
    }

  private:
    void transport() {
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
        const bool playing = run_.playing();
        if (ui_.accent_button(playing ? "Pause###play" : "Play###play", "play", width,
                              {"", "Lets the run go on, or stands it still.", "Key: Space", "", ""}))
            run_.play(!playing);
        ImGui::SameLine();
        if (ui_.button("Step", "step", width, {"", "One step, then pause. Key: full stop", "", "", ""}))
            run_.step();
        ImGui::SameLine();
        if (ui_.button(
                "Reset", "reset", -FLT_MIN,
                {"", "Back to the start of the scene, with the schemes as they are set. Key: R", "", "", ""}))
            run_.restart();
    }

    void files() {
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
        if (ui_.button("Open…", "open", width,
                       {"Open",
                        "A preset, a scene or run, or a picture of Whorl: it brings its run back. Files "
                        "can also be dropped on the window.",
                        "Key: Ctrl+O", "", ""}))
            files_.ask_open = true;
        ImGui::SameLine();
        if (ui_.button(
                "Save run", "save-run", -FLT_MIN,
                {"Save run",
                 "The scene, the lanes and all that was done, as whorl-0001.toml, the next free number, in "
                 "the folder the program was started in. Opened again it gives the same bits.",
                 "Key: Ctrl+S", "", ""}))
            files_.save_run = true;
    }

    void scene_item(std::string_view key, const Scene& scene, std::string_view help, std::string_view source,
                    std::string_view hint) {
        const std::string id = scene.title + "##" + std::string(key);
        const bool chosen = run_.loaded() == key;
        const std::string name = "scene=" + std::string(key);
        if (ui_.list_item(id.c_str(), name, chosen, {scene.title, help, hint, source, ""}))
            run_.load_scene(key, scene);
    }

    void scenes() {
        row_label(ui_.theme, "Scene");
        const float room = ImGui::CalcItemWidth() - 1.4f * ImGui::GetFrameHeight();
        if (ImGui::BeginCombo("##scene", fitted(run_.scene().title, room).c_str(),
                              ImGuiComboFlags_HeightLargest)) {
            int digit = 1;
            for (const Preset& preset : presets()) {
                const std::string hint = "Key: " + std::to_string(digit++);
                const Scene scene = preset.scene();
                const Experiment& start = experiment(scene.experiment);
                scene_item(preset.key, scene, start.info.help, start.info.source, hint);
            }
            ImGui::Separator();
            ImGui::PushFont(ui_.theme.small);
            text(ui_.theme.palette.text_dim, "Experiments");
            ImGui::PopFont();
            for (const Experiment& e : experiments()) {
                if (!e.listed) continue;
                Scene scene = scene_of(e);
                const std::string hint = std::to_string(scene.resolution) + " cells along the width";
                std::string key(e.info.key);
                if (is_preset(key)) {  // of that name, but finer
                    key += "-experiment";
                    scene.title += ", " + std::to_string(scene.resolution) + " cells wide";
                }
                scene_item(key, scene, e.info.help, e.info.source, hint);
            }
            ImGui::EndCombo();
        }
        const Experiment& start = experiment(run_.scene().experiment);
        ui_.explain("scene", {run_.scene().title, start.info.help, "", start.info.source, ""});
    }

    void pace() {
        Pace pace = run_.pace();
        row_label(ui_.theme, "Steps a frame");
        bool changed = ui_.slider("##steps per frame", "steps-per-frame", pace.steps_per_frame, {1, 16},
                                  {"Steps per frame",
                                   "How many time steps the run may take for each frame of the window. If "
                                   "they take longer, the run is "
                                   "slower, not the window.",
                                   "", "", pace.unlimited ? "The run goes as fast as it can." : ""});
        if (ui_.check("As fast as it can", "unlimited", pace.unlimited,
                      {"As fast as it can", "Steps without waiting for the window's frames.", "", "", ""})) {
            pace.unlimited = !pace.unlimited;
            changed = true;
        }
        if (changed) run_.set_pace(pace);
    }

    Ui& ui_;
    RunControl& run_;
    FileRequests& files_;
};

}  // namespace

const PanelEntry run_panel{
    .key = "run", .title = "Run", .make = [](const Services& s) -> std::unique_ptr<Panel> {
        return std::make_unique<RunPanel>(s.ui, s.run, s.files);
    }};

}  // namespace whorl::app
