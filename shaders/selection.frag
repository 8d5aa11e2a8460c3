#version 450 core
// Which selected object a pixel shows: 0 = none. Exact, whatever encloses the object on the way here.
in vec3 v_unit;
in float v_depth;    // of v_unit along the view axis
flat in vec4 v_eye;  // w 1: where rays start; w 0: where they all go, one unit of depth long
flat in uint v_form;
flat in uint v_id;
out uint id;

const uint kBall = 1u, kDisk = 3u, kTriangle = 4u;  // as enum OutlineForm

// The depth at parameter t of a pixel's ray, which is 1, or 0 if rays are parallel, at v_unit.
float depth_at(float t) {
    return v_eye.w > 0 ? v_depth * t : v_depth + t;
}

void main() {
    float depth = v_depth;
    if (v_form == kBall) {
        // The pixel's ray against the unit sphere.
        const vec3 from = v_eye.w > 0 ? v_eye.xyz : v_unit;
        const vec3 to = v_eye.w > 0 ? v_unit - v_eye.xyz : v_eye.xyz;
        const float a = dot(to, to), middle = -dot(from, to) / a;
        const vec3 nearest = from + to * middle;
        const float square = 1 - dot(nearest, nearest);
        if (square < 0) discard;
        const float half_chord = sqrt(square / a);
        depth = depth_at(middle - half_chord);
        if (depth <= 0) depth = depth_at(middle + half_chord);
    } else if (v_form == kDisk) {
        if (dot(v_unit.xy, v_unit.xy) > 1) discard;
    } else if (v_form == kTriangle) {  // a triangle: the lower left half of the square
        if (v_unit.x + v_unit.y > 0) discard;
    }
    if (depth <= 0) discard;
    id = v_id;
    gl_FragDepth = depth / (1 + depth);
}
