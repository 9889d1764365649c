#version 330 core
// A thin arrow, light with a dark halo so that it reads on any colour.
in vec2 local;
flat in float shaft;
uniform float scale;
out vec4 colour;

float to_segment(vec2 p, vec2 a, vec2 b) {
    vec2 ab = b - a;
    float t = clamp(dot(p - a, ab) / max(dot(ab, ab), 1e-6), 0.0, 1.0);
    return length(p - a - ab * t);
}

void main() {
    float head = min(4.0 * scale, 0.45 * shaft);
    vec2 p = vec2(local.x, abs(local.y));
    float d = to_segment(p, vec2(0.0), vec2(shaft, 0.0));
    d = min(d, to_segment(p, vec2(shaft - head, head * 0.7), vec2(shaft, 0.0)));
    float core = 1.0 - smoothstep(0.5 * scale - 0.4, 0.5 * scale + 0.6, d);
    float halo = 1.0 - smoothstep(0.6 * scale, 2.2 * scale, d);
    float alpha = max(core * 0.95, halo * 0.55);
    colour = vec4(vec3(core), alpha);
}
