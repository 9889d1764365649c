// Fields on the screen, without a screen.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "app/render/arrows.h"
#include "app/render/egl_context.h"
#include "app/render/framebuffer.h"
#include "app/render/solids.h"

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

TEST_F(Render, ValuesBelowAMapThatBeginsAtZeroHaveAColourOfTheirOwn) {
    Field field(4, 1, Site::Centre);
    const float values[] = {0, -1e-6f, -0.5f * full_depth, -1};
    for (int i = 0; i < 4; ++i) field(i, 0) = static_cast<Real>(values[i]);
    FieldDraw how;
    how.crisp = true;
    const Image image = draw(field, 40, how);
    expect_grey(image, 5, 20, 0);
    expect_grey(image, 15, 20, 0);
    const auto expect = [&](int x, glm::vec3 colour) {
        const Rgb got = pixel(image, x, 20);
        const glm::vec3 wanted = 255.0f * colour;
        // Two texels of those between the two colours.
        const float near = 2 * 255.0f / ColourMapTexture::before + tolerance;
        EXPECT_NEAR(static_cast<float>(got.r), wanted.r, near);
        EXPECT_NEAR(static_cast<float>(got.g), wanted.g, near);
        EXPECT_NEAR(static_cast<float>(got.b), wanted.b, near);
    };
    expect(25, glm::mix(below_colour, glm::vec3(1), 0.5f));  // the map begins with white
    expect(35, below_colour);
    how.lo = 0.25f;  // who begins above 0 has chosen what not to see
    const Image chosen = draw(field, 40, how);
    for (const int x : {5, 15, 25, 35}) expect_grey(chosen, x, 20, 0);
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

/// 16 × 16 with a value of its own in every cell.
Field checks() {
    Field field(16, 16, Site::Centre);
    for (int j = 0; j < 16; ++j) {
        for (int i = 0; i < 16; ++i) field(i, j) = static_cast<Real>((i * 7 + j * 13) % 17) / Real(16);
    }
    return field;
}

TEST_F(Render, AWindowIsTheWholeSeenCloser) {
    const Field field = checks();
    for (const bool crisp : {false, true}) {
        FieldDraw how;
        how.crisp = crisp;
        const Image whole = draw(field, 320, how);
        how.window = {{0.25f, 0.5f}, {0.5f, 0.75f}};
        const Image part = draw(field, 80, how);
        for (int y = 0; y < 80; ++y) {
            for (int x = 0; x < 80; ++x) {
                ASSERT_NEAR(pixel(part, x, y).r, pixel(whole, 80 + x, 80 + y).r, tolerance)
                    << x << ", " << y << (crisp ? " crisp" : " smooth");
            }
        }
    }
}

TEST_F(Render, SolidsCoverTheirCellsInEveryWindow) {
    std::vector<std::uint8_t> mask(256, 0);
    Field cells(16, 16, Site::Centre, Real(0));
    for (const auto& [i, j] : {std::pair{5, 9}, {6, 9}, {6, 10}, {4, 12}, {0, 0}, {15, 15}}) {
        mask[static_cast<std::size_t>(16 * j + i)] = 1;
        cells(i, j) = 1;
    }
    ViewWindow window;
    for (const float factor : {1.0f, 1.37f, 1.2f, 1.1f, 1.05f}) {
        window = zoomed(window, {0.31f, 0.62f}, factor, {16, 16});
        FieldDraw how;
        how.crisp = true;
        how.window = window;
        const Image black = draw(cells, 101, how);
        const Image grey = draw(Field(16, 16, Site::Centre, Real(0)), 101, how, mask);
        for (int y = 0; y < 101; ++y) {
            for (int x = 0; x < 101; ++x) {
                ASSERT_EQ(pixel(black, x, y).r < 128, pixel(grey, x, y).r < 250) << x << ", " << y;
            }
        }
    }
}

TEST_F(Render, ArrowsShowTheWindowsVelocity) {
    // Still but for the upper right quarter.
    FaceVelocity velocity{Field(17, 16, Site::FaceX), Field(16, 17, Site::FaceY)};
    for (int j = 8; j < 17; ++j) {
        for (int i = 8; i < 16; ++i) velocity.v(i, j) = 1;
    }
    Framebuffer target(80, 80);
    target.bind();
    glClearColor(0, 0, 0, 1);
    Arrows arrows;
    const auto bright = [&](ViewWindow window, std::optional<PixelRect> clip, PixelRect counted) {
        FieldDraw how;
        how.rect = {0, 0, 80, 80};
        how.framebuffer_height = 80;
        how.window = window;
        how.clip = clip;
        glClear(GL_COLOR_BUFFER_BIT);
        arrows.draw(velocity, how, {.spacing = 20});
        const Image image = target.read();
        int count = 0;
        for (int y = counted.y; y < counted.y + counted.height; ++y) {
            for (int x = counted.x; x < counted.x + counted.width; ++x) count += pixel(image, x, y).r > 100;
        }
        return count;
    };
    const PixelRect all{0, 0, 80, 80}, left{0, 0, 40, 80}, right{40, 0, 40, 80};
    EXPECT_EQ(bright({{0.0f, 0.0f}, {0.45f, 0.45f}}, {}, all), 0);
    EXPECT_GT(bright({{0.55f, 0.55f}, {1.0f, 1.0f}}, {}, left), 0);
    EXPECT_GT(bright({{0.55f, 0.55f}, {1.0f, 1.0f}}, {}, right), 0);
    EXPECT_EQ(bright({}, {}, left), 0);
    EXPECT_GT(bright({}, {}, right), 0);
    EXPECT_EQ(bright({{0.55f, 0.55f}, {1.0f, 1.0f}}, left, right), 0) << "clipped";
    EXPECT_GT(bright({{0.55f, 0.55f}, {1.0f, 1.0f}}, left, left), 0);
    EXPECT_FLOAT_EQ(arrows.fastest(velocity, {.rect = all, .framebuffer_height = 80}), 1.0f);
    EXPECT_FLOAT_EQ(arrows.fastest(velocity, {.rect = all, .window = {{0.0f, 0.0f}, {0.4f, 0.4f}}}), 0.0f);
}

TEST_F(Render, TwoFieldsShareAPlaceLeftAndRightOfALine) {
    const std::vector<std::uint8_t> rock(256, 1);
    const Field field = checks();
    FieldDraw how;
    how.crisp = true;
    how.window = {{0.1f, 0.2f}, {0.7f, 0.8f}};
    const Image smoke = draw(field, 64, how);
    const Image wall = draw(field, 64, how, rock);
    Framebuffer target(64, 64);
    target.bind();
    FieldTexture texture;
    texture.upload(field);
    Solids solids;
    solids.upload(rock, 16, 16);
    FieldView view;
    how.rect = {0, 0, 64, 64};
    how.framebuffer_height = 64;
    const ColourMap& map = *find_colour_map("white-black");
    glScissor(1, 2, 3, 4);
    for (const int line : {0, 23, 64}) {
        how.clip = PixelRect{0, 0, line, 64};
        view.draw(texture, map, how);
        how.clip = PixelRect{line, 0, 64 - line, 64};
        view.draw(texture, map, how);
        solids.draw(map, how);
        const Image image = target.read();
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                ASSERT_EQ(pixel(image, x, y).r, pixel(x < line ? smoke : wall, x, y).r) << x << ", " << y;
            }
        }
    }
    how.clip = PixelRect{10, 10, -5, 64};
    view.draw(texture, map, how);
    GLint box[4];
    glGetIntegerv(GL_SCISSOR_BOX, box);
    EXPECT_EQ(box[0] + 10 * box[1] + 100 * box[2] + 1000 * box[3], 4321)
        << "the next one's clip is left alone";
    EXPECT_EQ(glIsEnabled(GL_SCISSOR_TEST), GL_FALSE);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace whorl::app
