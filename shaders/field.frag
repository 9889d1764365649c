#version 330 core
// A scalar field through a colour map; values that are no number as a chequer.
// CRISP: squares of one value each, else bilinear between samples. AVERAGED: several samples a pixel.
uniform sampler2D field;
uniform sampler1D map;
uniform vec2 corner;        // of the picture's rectangle, framebuffer pixels from bottom left
uniform vec2 pixel_origin;  // position of that corner in the domain, cells
uniform vec2 pixel_size;    // of one pixel, cells
uniform vec2 cells;         // size of the domain, cells
uniform vec2 offset;        // of the field's first sample, cells
uniform vec2 range;         // value at the map's start, 1 / (value at its end - value at its start)
uniform int taps;           // samples a pixel, along each side
uniform float chequer;      // 1 / size of its squares, 1 / framebuffer pixels
uniform vec3 texels;        // of the map: from its start to its end, those before its start, the first one used
uniform vec3 outside;       // colour beyond the domain
out vec4 colour;

float value_at(vec2 place) {
#ifdef CRISP
    return texelFetch(field, clamp(ivec2(floor(place - offset + 0.5)), ivec2(0), textureSize(field, 0) - 1), 0).r;
#else
    return texture(field, (place - offset + 0.5) / vec2(textureSize(field, 0))).r;
#endif
}

vec3 mapped(vec2 place) {
    float value = value_at(place);
    float texel = (value - range.x) * range.y * texels.x + texels.y;
    vec3 shade = texelFetch(map, int(clamp(texel, texels.z, texels.x + texels.y) + 0.5), 0).rgb;
    ivec2 square = ivec2(gl_FragCoord.xy * chequer);
    vec3 broken = ((square.x ^ square.y) & 1) != 0 ? vec3(0.85, 0.20, 0.75) : vec3(0.18, 0.04, 0.16);
    return isnan(value) ? broken : shade;
}

void main() {
    vec2 place = pixel_origin + (gl_FragCoord.xy - corner) * pixel_size;
#ifdef AVERAGED
    vec3 sum = vec3(0.0);
    for (int b = 0; b < taps; ++b) {
        for (int a = 0; a < taps; ++a) {
            vec2 shift = (vec2(float(a), float(b)) + 0.5) / float(taps) - 0.5;
            sum += mapped(place + shift * pixel_size);
        }
    }
    vec3 inside = sum / float(taps * taps);
#else
    vec3 inside = mapped(place);
#endif
    bool beyond = any(lessThan(place, vec2(0.0))) || any(greaterThan(place, cells));
    colour = vec4(beyond ? outside : inside, 1.0);
}
