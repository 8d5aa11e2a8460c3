#version 450 core
// Lines on the plane y = 0: each ten times as far apart as those before, the finest where the camera is near it.
// The x axis is red, the z axis blue.
layout(location = 1) uniform vec3 u_eye;
layout(location = 2) uniform mat3 u_ray;       // direction for v_uv.x, for v_uv.y, and at (0, 0)
layout(location = 8) uniform mat3 u_start;     // the same of where rays start, from the eye
layout(location = 5) uniform float u_step;     // between the finest lines, in scene units
layout(location = 6) uniform float u_fading;   // 0 to 1: how far the finest lines have gone
layout(location = 7) uniform vec2 u_eye_rest;  // x and z of the eye within a square of 100 steps
in vec2 v_uv;
out vec4 color;

const float kFine = 0.3, kCoarse = 0.6, kAxis = 0.8;

// Coverage of lines at whole numbers of `p`, a pixel being `width`; they vanish where they come too close.
float lines(vec2 p, vec2 width) {
    const vec2 cover = max(1 - abs(p - round(p)) / width, 0) * (1 - smoothstep(0.15, 0.5, width));
    return max(cover.x, cover.y);
}

void main() {
    const vec3 direction = u_ray * vec3(v_uv, 1);
    const vec3 start = u_start * vec3(v_uv, 1);
    const float t = -(u_eye.y + start.y) / direction.y;
    const vec2 along = start.xz + direction.xz * t;
    const vec2 width = max(fwidth(along), vec2(1e-5 * u_step));
    if (!(t > 0)) discard;

    const vec2 p = (u_eye_rest + along) / u_step, w = width / u_step;
    float alpha = kFine * (1 - u_fading) * lines(p, w);
    alpha = max(alpha, mix(kCoarse, kFine, u_fading) * lines(p / 10, w / 10));
    alpha = max(alpha, kCoarse * lines(p / 100, w / 100));
    vec3 tint = vec3(0.95);
    const vec2 axis = max(1 - abs(u_eye.xz + along) / width, 0);  // coverage of x = 0, of z = 0
    if (axis.y > 0) tint = vec3(0.86, 0.25, 0.25);
    if (axis.x > 0) tint = vec3(0.30, 0.50, 0.95);
    alpha = max(alpha, kAxis * max(axis.x, axis.y));
    // Towards the horizon the plane would be a haze of lines.
    alpha *= smoothstep(0.0, 0.08, abs(normalize(direction).y));
    if (alpha < 0.004) discard;
    color = vec4(tint, alpha);
}
