#version 330 core
// One arrow an instance: a rectangle around it, with coordinates along and across the arrow in pixels.
layout(location = 0) in vec4 arrow;  // tail, then tip minus tail; framebuffer pixels from the rectangle's corner
uniform vec2 size;                   // of the rectangle, framebuffer pixels
uniform float scale;
out vec2 local;
flat out float shaft;

void main() {
    float margin = 5.0 * scale;
    shaft = length(arrow.zw);
    vec2 along = arrow.zw / max(shaft, 1e-6);
    vec2 across = vec2(-along.y, along.x);
    vec2 unit = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    local = vec2(mix(-margin, shaft + margin, unit.x), mix(-margin, margin, unit.y));
    vec2 pixel = arrow.xy + along * local.x + across * local.y;
    gl_Position = vec4(pixel / size * 2.0 - 1.0, 0.0, 1.0);
}
