// Fields and pictures beside a window's ImGui frames.
#include <gtest/gtest.h>

#include "app/figure/picture.h"
#include "app/render/field_view.h"
#include "tests/support/headless_ui.h"

namespace whorl::app {
namespace {

TEST(ImGuiFrame, APictureBetweenTwoFramesDisturbsNeither) {
    HeadlessUi ui(300, 200, 1.0f);
    const auto draw = [] { ImGui::Text("∇·u = 0"); };
    for (int k = 0; k < 2; ++k) ui.frame(draw);
    const Image before = ui.picture();
    const Field field(4, 4, Site::Centre, Real(0.5));
    EXPECT_GT(render_picture({.rows = {{.cells = {{.field = &field}}}}, .map = &colour_maps().front()}).width,
              0);
    ui.frame(draw);
    EXPECT_EQ(ui.picture(), before);
}

TEST(ImGuiFrame, TakesAFieldAmongItsCommands) {
    HeadlessUi ui(200, 200, 1.0f);
    FieldView view;
    FieldTexture texture;
    texture.upload(Field(2, 2, Site::Centre, Real(1)));
    struct Call {
        FieldView& view;
        FieldTexture& texture;
        FieldDraw draw;
    } call{view, texture, {.rect = {50, 60, 100, 80}, .framebuffer_height = 200, .crisp = true}};
    ui.frame([&] {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled({50, 60}, {150, 140}, IM_COL32(255, 0, 0, 255));
        list.AddCallback(
            [](const ImDrawList*, const ImDrawCmd* command) {
                const Call& c = *static_cast<const Call*>(command->UserCallbackData);
                c.view.draw(c.texture, *find_colour_map("white-black"), c.draw);
            },
            &call);
        list.AddRectFilled({80, 90}, {120, 110}, IM_COL32(0, 255, 0, 255));
    });
    const Image image = ui.picture();
    const auto pixel = [&](int x, int y) {
        const std::uint8_t* p = image.rgba.data() + 4 * (std::size_t{200} * y + x);
        return (p[0] << 16) | (p[1] << 8) | p[2];
    };
    EXPECT_EQ(pixel(50, 60), 0x000000) << "the field covers what was drawn before";
    EXPECT_EQ(pixel(149, 139), 0x000000);
    EXPECT_EQ(pixel(100, 100), 0x00ff00) << "and lies under what is drawn after";
    EXPECT_NE(pixel(150, 140), 0x000000);
}

}  // namespace
}  // namespace whorl::app
