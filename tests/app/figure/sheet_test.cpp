// Sheets: what they share, how they are drawn, and what is refused.
#include "app/figure/sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "app/figure/picture.h"
#include "app/figure/sheet_layout.h"
#include "tests/app/figure/sheet_cells.h"
#include "tests/support/headless_ui.h"

namespace whorl::app {
namespace {

/// Rounding to 8 bits twice, in 1/255.
constexpr int tolerance = 1;

struct Rgb {
    int r, g, b;
    bool operator==(const Rgb&) const = default;
};
Rgb pixel(const Image& image, int x, int y) {
    const std::uint8_t* p = image.rgba.data() + 4 * (static_cast<std::size_t>(y) * image.width + x);
    return {p[0], p[1], p[2]};
}
Rgb rgb(ImU32 colour) {
    const auto part = [&](int shift) { return static_cast<int>((colour >> shift) & 0xff); };
    return {part(IM_COL32_R_SHIFT), part(IM_COL32_G_SHIFT), part(IM_COL32_B_SHIFT)};
}
bool contains(const Image& image, Rgb colour) {
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (pixel(image, x, y) == colour) return true;
        }
    }
    return false;
}

class Sheets : public ::testing::Test {
  protected:
    EglContext context_;
    PictureRenderer renderer_;
};

TEST_F(Sheets, AreTheSameBytesTwice) {
    Field field(4, 4, Site::Centre);
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) field(i, j) = static_cast<Real>(0.2 * i + 0.1 * j);
    }
    const FaceVelocity velocity{Field(5, 4, Site::FaceX, Real(1)), Field(4, 5, Site::FaceY, Real(1))};
    SheetRequest request = request_of(arranged({lane(field, 0), lane(field, 1), lane(field, 2)}));
    request.title = "A plume";
    request.label = "ρ";
    request.caption = "step 10 · t = 0.5";
    request.rows[0].cells[1].arrows = &velocity;
    request.rows[0].cells[2].stopped = "stopped at step 9";
    request.plots = {{.title = "Energy", .curves = {{"lane 0", 0, {0, 1, 2}, {3, 5, 4}}}}};
    const Image first = render_picture(request);
    EXPECT_EQ(first, render_picture(request));
    EXPECT_EQ(first, renderer_.render(request));
    request.light = true;
    const Image light = renderer_.render(request);
    EXPECT_NE(first, light);
    request.light = false;
    request.scale = 2;
    const Image twice = renderer_.render(request);
    EXPECT_EQ(twice.width, 2 * first.width);
    // Every line of text rounds its height.
    EXPECT_NEAR(twice.height, 2 * first.height, 12);
    request.scale = 1;
    EXPECT_EQ(first, renderer_.render(request)) << "no state is left of another picture";
}

TEST_F(Sheets, AreDrawnInBandsWithoutASeam) {
    constexpr int n = 8;
    Field rising(n, n, Site::Centre);
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) rising(i, j) = static_cast<Real>(j) / (n - 1);
    }
    SheetRequest request = request_of({{"", {{.field = &rising}}}});
    request.cell_width = 1600;
    request.title = "Rising";
    ImGui::CreateContext();  // for the letters that the layout measures
    const PixelRect place = lay_out(request, load_theme(1)).cells[0].field;
    ImGui::DestroyContext();
    renderer_.begin(request);
    int bands = 1;
    std::optional<Image> image;
    while (!(image = renderer_.draw_band())) ++bands;
    EXPECT_GE(bands, 5);
    ASSERT_GE(image->height, place.y + place.height);
    // From white to black in steps that 1600 rows leave no larger, beside an edge of one colour.
    const int middle = place.x + place.width / 2;
    const Rgb edge = pixel(*image, place.x - 1, place.y);
    for (int y = place.y + 1; y < place.y + place.height; ++y) {
        const int step = pixel(*image, middle, y).r - pixel(*image, middle, y - 1).r;
        ASSERT_TRUE(std::abs(step) <= 1) << "row " << y << " of " << image->height;
        ASSERT_EQ(pixel(*image, place.x - 1, y), edge) << "row " << y;
    }
    EXPECT_EQ(*image, renderer_.render(request));
    // One that is given up leaves nothing behind.
    renderer_.begin(request);
    renderer_.draw_band();
    EXPECT_EQ(*image, renderer_.render(request));
}

TEST_F(Sheets, ShareOneRangeAcrossResolutions) {
    Field coarse(4, 4, Site::Centre), fine(8, 8, Site::Centre);
    for (int j = 0; j < 8; ++j) {
        for (int i = 0; i < 8; ++i)
            fine(i, j) = coarse(i / 2, j / 2) = static_cast<Real>(i / 2 + 4 * (j / 2));
    }
    SheetRequest request = request_of({{"", {{.field = &coarse}, {.field = &fine}}}});
    request.crisp = true;
    request.lo = -1;
    request.hi = 17;
    const Image image = renderer_.render(request);
    // Fields begin at the margin of 24 and are 200 wide, 12 apart.
    for (const int x : {3, 60, 120, 190}) {
        for (const int y : {3, 60, 120, 190}) {
            const Rgb left = pixel(image, 24 + x, 24 + y);
            EXPECT_EQ(left, pixel(image, 24 + 200 + 12 + x, 24 + y)) << x << ", " << y;
            const float value = static_cast<float>(x / 50) + 4.0f * static_cast<float>(3 - y / 50);
            EXPECT_NEAR(left.r, static_cast<int>(std::lround(255.0f * (1.0f - (value + 1.0f) / 18.0f))),
                        tolerance);
        }
    }
}

TEST_F(Sheets, ShowWhichLaneACellIs) {
    const Field field(8, 8, Site::Centre, Real(0));
    SheetRequest request = request_of({{"", {lane(field, 0), lane(field, 4)}}});
    request.plots = {{.title = "Energy", .curves = {{"lane 2", 2, {0, 1}, {1, 1}}}}};
    for (const bool light : {false, true}) {
        request.light = light;
        const Theme theme{.palette = light ? light_palette() : dark_palette()};
        const Image image = renderer_.render(request);
        EXPECT_TRUE(contains(image, rgb(theme.lane(0))));
        EXPECT_TRUE(contains(image, rgb(theme.lane(2)))) << "a curve in its lane's colour";
        EXPECT_TRUE(contains(image, rgb(theme.lane(4))));
        EXPECT_FALSE(contains(image, rgb(theme.lane(3))));
    }
}

TEST_F(Sheets, SayOverTheFieldWhyALaneStopped) {
    const Field field(8, 8, Site::Centre, Real(0));
    SheetRequest request = request_of({{"", {{.field = &field}}}});
    const Image running = renderer_.render(request);
    request.rows[0].cells[0].stopped = "stopped at step 312: the density at cell (17, 23) is not finite";
    const Image stopped = renderer_.render(request);
    ASSERT_EQ(stopped.height, running.height);
    int changed = 0;
    for (int y = 0; y < stopped.height; ++y) {
        for (int x = 0; x < stopped.width; ++x) {
            if (pixel(stopped, x, y) == pixel(running, x, y)) continue;
            ++changed;
            // The field is 200 wide in the middle of what is 320 wide, below the margin of 24.
            ASSERT_TRUE(x >= 84 && x < 284 && y > 24 + 100 && y < 24 + 200) << x << ", " << y;
        }
    }
    EXPECT_GT(changed, 200 * 2 * 12) << "two lines";
}

TEST_F(Sheets, LeaveAPlaceWithoutAField) {
    const Field field(8, 8, Site::Centre, Real(0));
    SheetRequest request = request_of({{"step 1", {lane(field, 0), lane(field, 1)}}});
    const Image whole = renderer_.render(request);
    request.rows[0].cells[1].field = nullptr;
    const Image gap = renderer_.render(request);
    request.rows[0].cells[1].stopped = "stopped at step 0: no number in the density at (3, 4)";
    const Image reason = renderer_.render(request);
    EXPECT_EQ(gap.width, whole.width);
    EXPECT_EQ(gap.height, whole.height);
    EXPECT_EQ(reason.height, whole.height);
    EXPECT_NE(gap, whole);
    EXPECT_NE(reason, gap);
}

TEST_F(Sheets, AreDrawnInAnyShape) {
    for (const auto& [nx, ny] : {std::pair{1, 1}, {256, 1}, {3, 200}, {200, 3}}) {
        const Field field(nx, ny, Site::Centre, Real(0.5));
        SheetRequest request = request_of({{"", {{.field = &field}}}});
        request.lo = request.hi = 0.5f;
        request.cell_width = 400;
        request.caption = std::string(3000, 'm');
        const Image image = renderer_.render(request);
        EXPECT_GT(image.height, 100);
        EXPECT_LT(image.width, 600);
    }
}

TEST_F(Sheets, AreDrawnLargeForPrint) {
    const Field field(64, 64, Site::Centre, Real(0.5));
    std::vector<SheetRow> rows;
    for (int step = 0; step < 5; ++step) {
        SheetRow& row = rows.emplace_back(SheetRow{"step " + std::to_string(step), {}});
        for (int k = 0; k < 5; ++k) row.cells.push_back(lane(field, k));
    }
    SheetRequest sheet = request_of(rows);
    sheet.scale = 2;
    EXPECT_GT(renderer_.render(sheet).height, 2000);
    std::vector<SheetCell> cells;
    for (int k = 0; k < 6; ++k) cells.push_back(lane(field, k));
    SheetRequest comparison = request_of(arranged(cells));
    comparison.scale = 4;
    comparison.plots.resize(3);
    EXPECT_GT(renderer_.render(comparison).width, 2400);
}

TEST_F(Sheets, RefuseWhatCannotBeDrawn) {
    const Field field(8, 8, Site::Centre), none;
    const SheetRequest good = request_of({{"", {lane(field, 0), lane(field, 1), lane(field, 2)}}});
    const auto refusal = [&](auto&& change) -> std::string {
        SheetRequest request = good;
        change(request);
        try {
            renderer_.render(request);
        } catch (const std::exception& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal([](SheetRequest&) {}), "");
    const std::string large = refusal([](SheetRequest& r) { r.cell_width = 16000; });
    EXPECT_NE(large.find("the limit is"), std::string::npos) << large;
    EXPECT_EQ(large.find('\n'), std::string::npos);
    const std::string long_text = refusal([](SheetRequest& r) { r.caption = std::string(2'000'000, 'm'); });
    EXPECT_NE(long_text.find("the limit is"), std::string::npos) << long_text;
    for (const float wrong : {0.0f, -1.0f, NAN, INFINITY, 1e30f}) {
        EXPECT_NE(refusal([&](SheetRequest& r) { r.scale = wrong; }), "") << wrong;
        EXPECT_NE(refusal([&](SheetRequest& r) { r.cell_width = wrong; }), "") << wrong;
    }
    EXPECT_NE(refusal([](SheetRequest& r) { r.rows.clear(); }), "");
    EXPECT_NE(refusal([](SheetRequest& r) { r.map = nullptr; }), "");
    EXPECT_NE(refusal([&](SheetRequest& r) { r.rows[0].cells[1].field = &none; }), "");
    const std::vector<std::uint8_t> mask(63);
    EXPECT_NE(refusal([&](SheetRequest& r) { r.rows[0].cells[1].solids = mask; }), "");
    EXPECT_EQ(refusal([](SheetRequest&) {}), "") << "a refusal leaves nothing behind";
}

}  // namespace
}  // namespace whorl::app
