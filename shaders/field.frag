#version 330 core
// A scalar field through a colour map, solid cells in hatched grey, values that are no number in a chequer.
uniform sampler2D field;
uniform sampler1D map;
uniform usampler2D solids;  // a texel a cell, non-zero is solid
uniform vec2 corner;        // of the picture's rectangle, framebuffer pixels from bottom left
uniform vec2 pixel_origin;  // position of that corner in the domain, cells
uniform vec2 pixel_size;    // of one pixel, cells
uniform vec2 cells;         // size of the domain, cells
uniform vec2 offset;        // of the field's first sample, cells
uniform vec2 range;         // value at the map's start, 1 / (value at its end - value at its start)
uniform bool crisp;
uniform bool has_solids;
uniform int taps;           // samples a pixel, along each side
uniform float scale;        // framebuffer pixels to a point
uniform vec3 solid_fill;
uniform vec3 solid_hatch;
uniform vec3 solid_edge;
uniform vec3 outside;       // colour beyond the domain
out vec4 colour;

float texel(ivec2 k) {
    return texelFetch(field, clamp(k, ivec2(0), textureSize(field, 0) - 1), 0).r;
}

float value_at(vec2 place) {
    vec2 sample_place = place - offset;
    if (crisp) return texel(ivec2(floor(sample_place + 0.5)));
    vec2 low = floor(sample_place);
    vec2 w = sample_place - low;
    ivec2 k = ivec2(low);
    return mix(mix(texel(k), texel(k + ivec2(1, 0)), w.x), mix(texel(k + ivec2(0, 1)), texel(k + ivec2(1, 1)), w.x), w.y);
}

bool solid_at(vec2 place) {
    ivec2 cell = ivec2(clamp(floor(place), vec2(0.0), cells - 1.0));
    return texelFetch(solids, cell, 0).r != 0u;
}

vec3 mapped(vec2 place) {
    float value = value_at(place);
    if (isnan(value)) {
        bool light = mod(floor(gl_FragCoord.x / (5.0 * scale)) + floor(gl_FragCoord.y / (5.0 * scale)), 2.0) < 0.5;
        return light ? vec3(0.85, 0.20, 0.75) : vec3(0.18, 0.04, 0.16);
    }
    float t = clamp((value - range.x) * range.y, 0.0, 1.0);
    float texels = float(textureSize(map, 0));
    return texture(map, (t * (texels - 1.0) + 0.5) / texels).rgb;
}

vec3 solid_colour(vec2 place) {
    vec2 reach = pixel_size * 1.5 * scale;
    bool inside = solid_at(place + vec2(reach.x, 0.0)) && solid_at(place - vec2(reach.x, 0.0)) &&
                  solid_at(place + vec2(0.0, reach.y)) && solid_at(place - vec2(0.0, reach.y));
    if (!inside) return solid_edge;
    vec2 p = gl_FragCoord.xy - corner;
    float stripe = abs(mod(p.x + p.y, 9.0 * scale) - 4.5 * scale) / scale;
    return mix(solid_hatch, solid_fill, smoothstep(0.4, 1.2, stripe));
}

void main() {
    vec2 place = pixel_origin + (gl_FragCoord.xy - corner) * pixel_size;
    if (any(lessThan(place, vec2(0.0))) || any(greaterThan(place, cells))) {
        colour = vec4(outside, 1.0);
        return;
    }
    if (has_solids && solid_at(place)) {
        colour = vec4(solid_colour(place), 1.0);
        return;
    }
    vec3 sum = vec3(0.0);
    for (int b = 0; b < taps; ++b) {
        for (int a = 0; a < taps; ++a) {
            vec2 shift = (vec2(float(a), float(b)) + 0.5) / float(taps) - 0.5;
            sum += mapped(place + shift * pixel_size);
        }
    }
    colour = vec4(sum / float(taps * taps), 1.0);
}
