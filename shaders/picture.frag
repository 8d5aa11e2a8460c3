#version 450 core
// The render, pixel by pixel or interpolated, with lines between large pixels.
layout(binding = 0) uniform sampler2D u_picture;  // its first row is the top one
layout(location = 1) uniform bool u_nearest;
layout(location = 2) uniform bool u_pixel_grid;
in vec2 v_uv;
out vec4 color;

const vec3 kLineColor = vec3(0.5);
const float kLineStrength = 0.35;

void main() {
    const vec2 size = vec2(textureSize(u_picture, 0));
    const vec2 at = v_uv * size;
    color.rgb = u_nearest ? texelFetch(u_picture, clamp(ivec2(at), ivec2(0), ivec2(size) - 1), 0).rgb
                          : texture(u_picture, v_uv).rgb;
    color.a = 1;
    if (u_pixel_grid) {
        const vec2 to_line = abs(at - round(at)) / fwidth(at);  // in pixels of the window
        if (min(to_line.x, to_line.y) < 0.5) color.rgb = mix(color.rgb, kLineColor, kLineStrength);
    }
}
