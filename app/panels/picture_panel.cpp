// Pictures, animations and tables of the run.
#include <imgui.h>

#include <cmath>
#include <cstdio>

#include "app/panels/list.h"
#include "app/run/file_requests.h"
#include "app/ui/ui.h"

namespace whorl::app {
namespace {

class PicturePanel final : public Panel {
  public:
    PicturePanel(Ui& ui, FileRequests& files) : ui_(ui), files_(files) {}

    void draw() override {
        size_row();
        paper_row();
        bool& plots = files_.picture.plots;
        if (ui_.check("With the plots", "picture-plots", plots,
                      {"With the plots", "Puts the measures over steps beneath the fields.", "", "", ""}))
            plots = !plots;
        if (ui_.button(
                "Take picture", "picture", -FLT_MIN,
                {"Take picture",
                 "All that is compared as whorl-0001.png, the next free number, in the folder the program "
                 "was started in. The picture carries the run: opening it brings the run back at this "
                 "step.",
                 "Key: F12", "", ""}))
            files_.take_picture = true;
        film_row();
        if (ui_.button(
                "Save plots as CSV", "csv", -FLT_MIN,
                {"Save plots as CSV",
                 "The measures of every lane as whorl-0001.csv, a row a lane and step. Of a long run the "
                 "steps that the plots keep.",
                 "", "", ""}))
            files_.save_plots = true;
    }

  private:
    void size_row() {
        constexpr int scales[] = {1, 2, 4};
        row_label(ui_.theme, "Size");
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
        for (const int scale : scales) {
            if (scale != scales[0]) ImGui::SameLine();
            const std::string label = std::to_string(scale) + "×";
            const std::string key = "picture-size=" + std::to_string(scale);
            if (ui_.chip(label.c_str(), key, files_.picture.scale == scale, width,
                         {"Size of pictures",
                          "Pixels to a point: everything grows with it, lines and letters "
                          "too. 4× is for posters, and takes a moment.",
                          "", "", ""}))
                files_.picture.scale = scale;
        }
    }

    void paper_row() {
        row_label(ui_.theme, "Paper");
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
        bool& light = files_.picture.light;
        if (ui_.chip("Dark", "picture=dark", !light, width,
                     {"Dark", "Light on dark, as in the window.", "", "", ""}))
            light = false;
        ImGui::SameLine();
        if (ui_.chip("Light", "picture=light", light, width,
                     {"Light", "Dark on white, for print.", "", "", ""}))
            light = true;
    }

    void film_row() {
        if (!files_.filming) {
            if (ui_.button("Record animation…", "film", -FLT_MIN,
                           {"Record animation",
                            "The run from its start up to now as MP4, GIF or numbered pictures. It is worked "
                            "out again beside the window, which goes on.",
                            "", "", ""}))
                files_.ask_film = true;
            return;
        }
        char line[160];
        std::snprintf(line, sizeof line, "%s · %.0f s", files_.filming->name.c_str(),
                      files_.filming->seconds);
        if (ui_.button("Cancel", "film-cancel", 0,
                       {"Cancel the animation", "Stops recording it; nothing of it is left.", "", "", ""}))
            files_.cancel_film = true;
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        text(ui_.theme.palette.text_dim, fitted(line, ImGui::GetContentRegionAvail().x));
    }

    Ui& ui_;
    FileRequests& files_;
};

}  // namespace

const PanelEntry picture_panel{.key = "picture",
                               .title = "Picture",
                               .open = false,
                               .make = [](const Services& s) -> std::unique_ptr<Panel> {
                                   return std::make_unique<PicturePanel>(s.ui, s.files);
                               }};

}  // namespace whorl::app
