// Fields on the screen, without a screen.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "app/render/arrows.h"
#include "app/render/framebuffer.h"
#include "app/render/picture.h"
#include "app/render/solids.h"
#include "app/window/egl_context.h"

namespace whorl::app {
namespace {

/// Rounding to 8 bits twice, in 1/255.
constexpr int tolerance = 1;

class Render : public ::testing::Test {
  protected:
    struct Rgb {
        int r, g, b;
    };
    static Rgb pixel(const Image& image, int x, int y) {
        const std::uint8_t* p = image.rgba.data() + 4 * (static_cast<std::size_t>(y) * image.width + x);
        return {p[0], p[1], p[2]};
    }
    static void expect_grey(const Image& image, int x, int y, float value) {
        const int grey = static_cast<int>(std::lround(255.0f * (1.0f - value)));
        const Rgb got = pixel(image, x, y);
        EXPECT_NEAR(got.r, grey, tolerance) << x << ", " << y;
        EXPECT_EQ(got.r, got.g);
        EXPECT_EQ(got.g, got.b);
    }
    Image draw(const Field& field, int side, FieldDraw how = {}, std::span<const std::uint8_t> solid = {}) {
        Framebuffer target(side, side);
        target.bind();
        FieldTexture texture;
        texture.upload(field);
        if (how.rect.width == 0) how.rect = {0, 0, side, side};
        how.framebuffer_height = side;
        FieldView view;
        view.draw(texture, *find_colour_map("white-black"), how);
        Solids solids;
        solids.upload(solid, field.width(), field.height());
        solids.draw(*find_colour_map("white-black"), how);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        return target.read();
    }

    EglContext context_;
};

/// 4 × 4, growing to the right and, by less, upwards; ghosts hold what must not show.
Field ramp() {
    Field field(4, 4, Site::Centre, Real(1e6));
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) field(i, j) = static_cast<Real>(0.2 * i + 0.1 * j);
    }
    return field;
}

TEST_F(Render, CrispCellsHaveOneValueEachAndYPointsUp) {
    FieldDraw how;
    how.crisp = true;
    const Image image = draw(ramp(), 40, how);
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
            const float value = 0.2f * static_cast<float>(i) + 0.1f * static_cast<float>(j);
            for (const int at : {0, 5, 9}) expect_grey(image, 10 * i + at, 39 - 10 * j - at, value);
        }
    }
}

TEST_F(Render, SmoothIsBilinearBetweenCellCentres) {
    const Image image = draw(ramp(), 40);
    expect_grey(image, 0, 39, 0.0f);  // below the first centre: held
    expect_grey(image, 39, 0, 0.9f);  // beyond the last one
    expect_grey(image, 19, 19, 0.2f * (19.5f / 10 - 0.5f) + 0.1f * (20.5f / 10 - 0.5f));
    expect_grey(image, 12, 27, 0.2f * (12.5f / 10 - 0.5f) + 0.1f * (12.5f / 10 - 0.5f));
}

TEST_F(Render, FaceSamplesSitOnFaces) {
    Field field(5, 4, Site::FaceX);
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 5; ++i) field(i, j) = static_cast<Real>(0.25 * i);
    }
    const Image image = draw(field, 40);
    for (const int x : {0, 13, 39}) expect_grey(image, x, 20, (static_cast<float>(x) + 0.5f) / 40);
}

TEST_F(Render, ARangeMapsItsEnds) {
    FieldDraw how;
    how.lo = 0.3f;
    how.hi = 0.9f;
    how.crisp = true;
    const Image image = draw(ramp(), 40, how);
    expect_grey(image, 5, 35, 0.0f);
    expect_grey(image, 35, 5, 1.0f);
    expect_grey(image, 35, 35, 0.5f);
}

TEST_F(Render, AWindowShowsAPart) {
    FieldDraw how;
    how.crisp = true;
    how.window = {{0.5f, 0.0f}, {1.0f, 0.5f}};
    const Image image = draw(ramp(), 40, how);
    expect_grey(image, 1, 38, 0.4f);
    expect_grey(image, 38, 1, 0.7f);
}

TEST_F(Render, StaysInItsRectangle) {
    FieldDraw how;
    how.rect = {10, 4, 20, 20};
    how.crisp = true;
    Field field(1, 1, Site::Centre, Real(0));
    const Image image = draw(field, 40, how);
    int white = 0;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) white += pixel(image, x, y).r == 255 ? 1 : 0;
    }
    EXPECT_EQ(white, 400);
    EXPECT_EQ(pixel(image, 10, 4).r, 255);
    EXPECT_EQ(pixel(image, 29, 23).r, 255);
}

TEST_F(Render, ShowsWhatIsNoNumber) {
    Field field(1, 1, Site::Centre, static_cast<Real>(NAN));
    const Image image = draw(field, 40);
    bool colourful = true;
    for (int k = 0; k < 40; ++k) {
        const Rgb p = pixel(image, k, k / 2);
        colourful = colourful && p.r > p.g && p.b > p.g;
    }
    EXPECT_TRUE(colourful);
}

TEST_F(Render, SolidCellsAreMarked) {
    std::vector<std::uint8_t> mask(16, 0);
    mask[4 * 1 + 2] = 1;
    const Image image = draw(Field(4, 4, Site::Centre, Real(0)), 40, {}, mask);
    EXPECT_EQ(pixel(image, 15, 25).r, 255);
    EXPECT_LT(pixel(image, 25, 25).r, 225) << "row 1 from below, column 2";
    EXPECT_EQ(pixel(image, 25, 15).r, 255);
    EXPECT_LT(pixel(image, 20, 25).r, 120) << "edge";
    EXPECT_LT(pixel(image, 25, 20).r, 120) << "edge above";
    EXPECT_EQ(pixel(image, 25, 19).r, 255) << "edges lie inside";
    EXPECT_THROW(Solids().upload(mask, 3, 4), std::invalid_argument);
}

TEST_F(Render, AFieldOfAnotherSizeTakesTheTextureOver) {
    FieldTexture texture;
    texture.upload(Field(8, 2, Site::Centre));
    EXPECT_EQ(texture.width(), 8);
    texture.upload(Field(3, 5, Site::FaceY));
    EXPECT_EQ(texture.height(), 5);
    EXPECT_EQ(texture.site(), Site::FaceY);
    texture.upload(Field());
    EXPECT_TRUE(texture.empty());
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Render, ArrowsPointWhereTheVelocityPoints) {
    const FaceVelocity up{Field(5, 4, Site::FaceX), Field(4, 5, Site::FaceY, Real(2))};
    Framebuffer target(60, 60);
    target.bind();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    FieldDraw how;
    how.rect = {0, 0, 60, 60};
    how.framebuffer_height = 60;
    ArrowStyle style;
    style.spacing = 60;
    Arrows arrows;
    arrows.draw(up, how, style);
    const Image image = target.read();
    EXPECT_GT(pixel(image, 30, 30).r, 100);
    EXPECT_LT(pixel(image, 10, 30).r, 10);
    // The head is above the middle: a pixel beside the shaft lights up there only.
    EXPECT_GT(pixel(image, 32, 5).r, 60);
    EXPECT_LT(pixel(image, 33, 54).r, 30);
    glClear(GL_COLOR_BUFFER_BIT);
    const std::vector<std::uint8_t> rock(16, 1);
    arrows.draw(up, how, {.spacing = 60, .solids = rock});
    EXPECT_EQ(pixel(target.read(), 30, 30).r, 0) << "no arrows in solids";
    const FaceVelocity broken{Field(5, 4, Site::FaceX, static_cast<Real>(NAN)), Field(4, 5, Site::FaceY)};
    arrows.draw(broken, how, style);
    arrows.draw(FaceVelocity{}, how, style);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Render, ThePictureIsTheSameBytesTwice) {
    const Field field = ramp();
    const FaceVelocity velocity{Field(5, 4, Site::FaceX, Real(1)), Field(4, 5, Site::FaceY, Real(1))};
    PictureRequest request{.field = field,
                           .map = *find_colour_map("magma"),
                           .arrows = &velocity,
                           .title = "Smoke density",
                           .label = "ρ",
                           .caption = "step 10 · t = 0.5 s",
                           .width = 300};
    const Image first = render_picture(request);
    EXPECT_EQ(first, render_picture(request));
    PictureRenderer renderer;
    EXPECT_EQ(first, renderer.render(request));
    request.light = true;
    EXPECT_NE(first, renderer.render(request));
    request.light = false;
    EXPECT_EQ(first, renderer.render(request)) << "no state is left of another picture";
}

TEST_F(Render, APictureOfAnyShapeCanBeDrawn) {
    for (const auto& [nx, ny] : {std::pair{1, 1}, {256, 1}, {3, 200}, {200, 3}}) {
        const Field field(nx, ny, Site::Centre, Real(0.5));
        PictureRequest request{.field = field, .map = colour_maps().front()};
        request.lo = request.hi = 0.5f;
        request.width = 400;
        request.caption = std::string(3000, 'm');
        const Image image = render_picture(request);
        EXPECT_GT(image.height, 100);
        EXPECT_LT(image.width, 600);
    }
    const Field none;
    EXPECT_THROW(render_picture({.field = none, .map = colour_maps().front()}), std::invalid_argument);
}

}  // namespace
}  // namespace whorl::app
