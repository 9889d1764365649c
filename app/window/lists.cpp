#include "app/window/lists.h"

#include "app/inspector/list.h"
#include "app/labs/list.h"
#include "app/tools/list.h"

namespace whorl::app {

Registry<LabEntry>& labs() {
    static Registry<LabEntry> list{"lab", {&interpolation_lab, &stencil_lab, &slice_lab, &inspector_lab}};
    return list;
}

Registry<ToolEntry>& tools() {
    static Registry<ToolEntry> list{"tool", {&brush_tool, &inspect_tool, &slice_tool, &view_tool}};
    return list;
}

Registry<OverlayEntry>& overlays() {
    static Registry<OverlayEntry> list{"overlay", {&slice_overlay, &inspected_overlay, &brush_ring}};
    return list;
}

}  // namespace whorl::app
