#version 330 core
// Rectangles of solid cells, and thin ones along their edges.
layout(location = 0) in vec4 box;     // two corners, cells
layout(location = 1) in vec2 inward;  // of an edge, whose box has no width that way; 0 for a filled rectangle
uniform vec2 pixel_origin;            // position of the picture's lower left corner, cells
uniform vec2 pixel_size;              // of one pixel, cells
uniform vec2 size;                    // of the picture, framebuffer pixels
uniform float thickness;              // of an edge, framebuffer pixels
flat out float edge;

void main() {
    vec2 unit = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 pixel = (mix(box.xy, box.zw, unit) - pixel_origin) / pixel_size;
    // Whole pixels: edges are equally thick everywhere.
    pixel = floor(pixel + 0.5) + inward * unit * thickness;
    edge = dot(inward, inward);
    gl_Position = vec4(pixel / size * 2.0 - 1.0, 0.0, 1.0);
}
