#version 450 core
// Which selected object a pixel shows: 0 = none. Exact, whatever encloses the object on the way here.
in vec3 v_unit;
flat in vec3 v_eye;
flat in uint v_form;
flat in uint v_id;
out uint id;

const uint kBall = 1u, kDisk = 3u, kTriangle = 4u;  // as enum OutlineForm

void main() {
    float depth = 1 / gl_FragCoord.w;  // along the view axis; grows in proportion along the pixel's ray
    if (v_form == kBall) {
        // The ray from the eye through v_unit against the unit sphere.
        const vec3 to = v_unit - v_eye;
        const float a = dot(to, to);
        const vec3 nearest = v_eye - to * (dot(v_eye, to) / a);
        const float square = 1 - dot(nearest, nearest);
        if (square < 0) discard;
        const float middle = -dot(v_eye, to) / a, half_chord = sqrt(square / a);
        const float t = middle - half_chord > 0 ? middle - half_chord : middle + half_chord;
        if (t <= 0) discard;
        depth *= t;
    } else if (v_form == kDisk) {
        if (dot(v_unit.xy, v_unit.xy) > 1) discard;
    } else if (v_form == kTriangle) {  // a triangle: the lower left half of the square
        if (v_unit.x + v_unit.y > 0) discard;
    }
    id = v_id;
    gl_FragDepth = depth / (1 + depth);
}
