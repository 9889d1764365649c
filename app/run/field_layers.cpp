#include "app/run/field_layers.h"

namespace whorl::app {

bool FieldLayers::take(const InputEvent& event, const FieldViewports& fields) {
    for (const auto& tool : tools_) {
        if (tool->take(event, fields)) return true;
    }
    return false;
}

void FieldLayers::end_frame() {
    for (const auto& tool : tools_) tool->end_frame();
}

void FieldLayers::draw(const FieldViewports& fields, ImDrawList& list) {
    bool claimed = false;
    for (const auto& tool : tools_) claimed = tool->hover(fields) || claimed;
    for (const auto& overlay : overlays_) overlay->draw(fields, list, claimed);
}

std::vector<PlotMark> FieldLayers::marks() const {
    std::vector<PlotMark> all;
    for (const auto& overlay : overlays_) {
        const std::vector<PlotMark> marks = overlay->marks();
        all.insert(all.end(), marks.begin(), marks.end());
    }
    return all;
}

void FieldLayers::hover_curves(double x, std::size_t lane) {
    for (const auto& tool : tools_) tool->hover_curves(x, lane);
}

std::span<const char* const> FieldLayers::hints(bool curves) const {
    for (const auto& tool : tools_) {
        if (const auto hints = tool->hints(curves); !hints.empty()) return hints;
    }
    return {};
}

}  // namespace whorl::app
