// The colours of curves and lanes, for normal and for colour-blind eyes.
#include "app/render/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace whorl::app {
namespace {

/// WCAG 2.1, 1.4.11: what is needed to understand a graphic stands out from its neighbours by this ratio.
constexpr double least_contrast = 3.0;
/// Distance in OKLab: several times the 0.02 that is just noticeable side by side, since curves lie apart.
constexpr float least_distance = 0.09f;

float linear(float s) {
    return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

glm::vec3 linear(ImU32 colour) {
    const auto part = [&](int shift) {
        return linear(static_cast<float>((colour >> shift) & 0xff) / 255.0f);
    };
    return {part(IM_COL32_R_SHIFT), part(IM_COL32_G_SHIFT), part(IM_COL32_B_SHIFT)};
}

double contrast(ImU32 a, ImU32 b) {
    const auto luminance = [](ImU32 colour) {
        return static_cast<double>(glm::dot(linear(colour), glm::vec3(0.2126f, 0.7152f, 0.0722f)));
    };
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

/// Ottosson 2020, from linear sRGB.
glm::vec3 oklab(glm::vec3 rgb) {
    const glm::vec3 lms{glm::dot(rgb, {0.4122214708f, 0.5363325363f, 0.0514459929f}),
                        glm::dot(rgb, {0.2119034982f, 0.6806995451f, 0.1073969566f}),
                        glm::dot(rgb, {0.0883024619f, 0.2817188376f, 0.6299787005f})};
    const glm::vec3 root{std::cbrt(lms.x), std::cbrt(lms.y), std::cbrt(lms.z)};
    return {glm::dot(root, {0.2104542553f, 0.7936177850f, -0.0040720468f}),
            glm::dot(root, {1.9779984951f, -2.4285922050f, 0.4505937099f}),
            glm::dot(root, {0.0259040371f, 0.7827717662f, -0.8086757660f})};
}

/// What an eye makes of linear sRGB, row by row: Machado, Oliveira and Fernandes 2009, severity 1.
struct Eye {
    const char* name;
    glm::vec3 red, green, blue;

    glm::vec3 see(glm::vec3 rgb) const {
        const glm::vec3 seen{glm::dot(red, rgb), glm::dot(green, rgb), glm::dot(blue, rgb)};
        return glm::clamp(seen, glm::vec3(0.0f), glm::vec3(1.0f));
    }
};
constexpr Eye eyes[] = {
    {"normal", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {"protanope",
     {0.152286f, 1.052583f, -0.204868f},
     {0.114503f, 0.786281f, 0.099216f},
     {-0.003882f, -0.048116f, 1.051998f}},
    {"deuteranope",
     {0.367322f, 0.860646f, -0.227968f},
     {0.280085f, 0.672501f, 0.047413f},
     {-0.011820f, 0.042940f, 0.968881f}},
    {"tritanope",
     {1.255528f, -0.076749f, -0.178779f},
     {-0.078411f, 0.930809f, 0.147602f},
     {0.004733f, 0.691367f, 0.303900f}},
};

TEST(Theme, LanesStandOutFromTheirGround) {
    for (const Palette& palette : {dark_palette(), light_palette()}) {
        const Theme theme{.palette = palette};
        for (int k = 0; k < 6; ++k) {
            EXPECT_GE(contrast(theme.lane(k), palette.card), least_contrast) << k;
            EXPECT_GE(contrast(theme.lane(k), palette.background), least_contrast) << k;
        }
    }
}

TEST(Theme, LanesAreToldApartByAnyEye) {
    for (const Palette& palette : {dark_palette(), light_palette()}) {
        for (const Eye& eye : eyes) {
            for (std::size_t a = 0; a < palette.series.size(); ++a) {
                for (std::size_t b = 0; b < a; ++b) {
                    const float apart = glm::distance(oklab(eye.see(linear(palette.series[a]))),
                                                      oklab(eye.see(linear(palette.series[b]))));
                    EXPECT_GE(apart, least_distance) << eye.name << ": " << a << " and " << b;
                }
            }
        }
    }
}

TEST(Theme, ALaneKeepsItsHueOnPaper) {
    for (std::size_t k = 0; k < 6; ++k) {
        const glm::vec3 dark = oklab(linear(dark_palette().series[k]));
        const glm::vec3 light = oklab(linear(light_palette().series[k]));
        const glm::vec2 a = glm::normalize(glm::vec2(dark.y, dark.z));
        const glm::vec2 b = glm::normalize(glm::vec2(light.y, light.z));
        // 60° is the distance between neighbours of six even hues; a lane stays nearer to itself.
        EXPECT_GT(glm::dot(a, b), std::cos(static_cast<float>(M_PI) / 6)) << k;
    }
}

}  // namespace
}  // namespace whorl::app
