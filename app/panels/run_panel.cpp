// Transport, timeline, files, scene and pace.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/panel.h"
#include "app/panels/timeline.h"
#include "app/scenes/presets.h"
#include "app/ui/widgets.h"
#include "core/experiments/experiment.h"

namespace whorl::app {

namespace {

void transport(PanelContext& context) {
    const Palette& palette = context.theme.palette;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
    const bool playing = context.client.playing();
    ImGui::PushStyleColor(ImGuiCol_Button, palette.accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, faded(palette.accent, 0.9f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, faded(palette.accent, 0.8f));
    ImGui::PushStyleColor(ImGuiCol_Text, palette.accent_text);
    if (ImGui::Button(playing ? "Pause###play" : "Play###play", {width, 0})) context.client.play(!playing);
    ImGui::PopStyleColor(4);
    context.log.control("play");
    context.tooltip.item(context.theme, "play",
                         {"", "Lets the run go on, or stands it still.", "Key: Space", "", ""});
    ImGui::SameLine();
    if (ImGui::Button("Step", {width, 0})) context.client.step();
    context.log.control("step");
    context.tooltip.item(context.theme, "step", {"", "One step, then pause. Key: full stop", "", "", ""});
    ImGui::SameLine();
    if (ImGui::Button("Reset", {-FLT_MIN, 0})) context.client.restart();
    context.log.control("reset");
    context.tooltip.item(
        context.theme, "reset",
        {"", "Back to the start of the scene, with the schemes as they are set. Key: R", "", "", ""});
}

void files(PanelContext& context) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
    if (ImGui::Button("Open…", {width, 0})) context.files.ask_open = true;
    context.log.control("open");
    context.tooltip.item(context.theme, "open",
                         {"Open",
                          "A preset, a scene or run, or a picture of Whorl: it brings its run back. Files "
                          "can also be dropped on the window.",
                          "Key: Ctrl+O", "", ""});
    ImGui::SameLine();
    if (ImGui::Button("Save run", {-FLT_MIN, 0})) context.files.save_run = true;
    context.log.control("save-run");
    context.tooltip.item(
        context.theme, "save-run",
        {"Save run",
         "The scene, the lanes and all that was done, as whorl-0001.toml, the next free number, in "
         "the folder the program was started in. Opened again it gives the same bits.",
         "Key: Ctrl+S", "", ""});
}

void scene_item(PanelContext& context, std::string_view key, const Scene& scene, std::string_view help,
                std::string_view source, std::string_view hint) {
    const std::string id = scene.title + "##" + std::string(key);
    const bool chosen = context.client.loaded() == key;
    if (list_item(id.c_str(), chosen)) context.client.load_scene(key, scene);
    const std::string name = "scene=" + std::string(key);
    context.log.control(name);
    context.tooltip.item(context.theme, name, {scene.title, help, hint, source, ""});
}

bool is_preset(std::string_view key) {
    return std::any_of(presets().begin(), presets().end(), [&](const Preset& p) { return p.key == key; });
}

void scenes(PanelContext& context) {
    row_label(context.theme, "Scene");
    const float room = ImGui::CalcItemWidth() - 1.4f * ImGui::GetFrameHeight();
    if (ImGui::BeginCombo("##scene", fitted(context.scene().title, room).c_str(),
                          ImGuiComboFlags_HeightLargest)) {
        int digit = 1;
        for (const Preset& preset : presets()) {
            const std::string hint = "Key: " + std::to_string(digit++);
            const Scene scene = preset.scene();
            const Experiment& start = experiment(scene.experiment);
            scene_item(context, preset.key, scene, start.info.help, start.info.source, hint);
        }
        ImGui::Separator();
        ImGui::PushFont(context.theme.small);
        text(context.theme.palette.text_dim, "Experiments");
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
            scene_item(context, key, scene, e.info.help, e.info.source, hint);
        }
        ImGui::EndCombo();
    }
    context.log.control("scene");
    const Experiment& start = experiment(context.scene().experiment);
    context.tooltip.item(context.theme, "scene",
                         {context.scene().title, start.info.help, "", start.info.source, ""});
}

void pace(PanelContext& context) {
    Pace pace = context.client.pace();
    row_label(context.theme, "Steps a frame");
    ImGui::BeginDisabled(pace.unlimited);
    bool changed = slider(context.theme, "##steps per frame", pace.steps_per_frame, {1, 16}, "");
    ImGui::EndDisabled();
    context.log.control("steps-per-frame");
    context.tooltip.item(context.theme, "steps-per-frame",
                         {"Steps per frame",
                          "How many time steps the run may take for each frame of the window. If they take "
                          "longer, the run is slower, not the window.",
                          "", "", pace.unlimited ? "The run goes as fast as it can." : ""});
    if (check("As fast as it can", pace.unlimited)) {
        pace.unlimited = !pace.unlimited;
        changed = true;
    }
    context.log.control("unlimited");
    context.tooltip.item(context.theme, "unlimited",
                         {"As fast as it can", "Steps without waiting for the window's frames.", "", "", ""});
    if (changed) context.client.set_pace(pace);
}

}  // namespace

void draw_run_panel(PanelContext& context) {
    transport(context);
    draw_timeline(context);
    files(context);
    scenes(context);
    pace(context);
}

}  // namespace whorl::app
