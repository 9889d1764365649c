#version 330 core
// Solid cells in quiet hatched grey.
flat in float edge;
uniform vec2 corner;  // of the picture's rectangle, framebuffer pixels from bottom left
uniform float scale;  // framebuffer pixels to a point
uniform vec3 fill_colour;
uniform vec3 hatch_colour;
uniform vec3 edge_colour;
out vec4 colour;

void main() {
    vec2 p = gl_FragCoord.xy - corner;
    float stripe = abs(mod(p.x + p.y, 9.0 * scale) - 4.5 * scale) / scale;
    vec3 inside = mix(hatch_colour, fill_colour, smoothstep(0.4, 1.2, stripe));
    colour = vec4(edge > 0.5 ? edge_colour : inside, 1.0);
}
