// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/solid_shader.h"

namespace sightline {

// The lamp on the viewer's head shines along the view and does not spread: the triangles of one plane look alike.
const char* const solid_face_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;
layout(location = 3) in vec2 lit_sliced;
uniform mat4 clip;
uniform vec3 eye;
uniform vec3 eye_rest;
uniform vec3 forward;
uniform vec3 lamp;    // where the fixed light comes from
uniform vec4 slice;   // normal and offset
flat out vec4 ink;

void main() {
    vec3 seen = (position - eye) - eye_rest;
    gl_Position = clip * vec4(seen, 1.0);
    gl_ClipDistance[0] = lit_sliced.y > 0.5 ? slice.w - dot(slice.xyz, position) : 1.0;
    float size = dot(normal, normal);
    float shade = 1.0;
    if (lit_sliced.x > 0.5 && size > 0.0) {
        vec3 n = normal * inversesqrt(size);
        if (dot(n, seen) > 0.0) n = -n;  // the side that is seen
        shade = 0.3 + 0.14 * abs(dot(n, forward)) + 0.56 * (0.5 + 0.5 * dot(n, lamp));
    }
    ink = vec4(colour.rgb * shade, colour.a);
}
)";

const char* const solid_face_fragment_shader = R"(#version 330 core
flat in vec4 ink;
out vec4 result;
void main() { result = ink; }
)";

const char* const solid_line_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colour;
layout(location = 3) in float width;   // half, in 1/64 pt
layout(location = 4) in float corner;
uniform mat4 clip;
uniform vec3 eye;
uniform vec3 eye_rest;
uniform float pt;                      // pixels to the point
flat out vec4 ink;
void main() {
    gl_Position = clip * vec4(((corner == 0.0 ? from : to) - eye) - eye_rest, 1.0);
    ink = vec4(colour.rgb, colour.a * min(1.0, width * (pt / 32.0)));
}
)";

// `uv` in pixels: along the edge from its start, and to the left of it.
const char* const solid_edge_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colour;
layout(location = 3) in float width;   // half, in 1/64 pt
layout(location = 4) in float corner;
uniform mat4 clip;
uniform vec3 eye;
uniform vec3 eye_rest;
uniform vec2 half_view;                // pixels
uniform float pt;                      // pixels to the point
flat out vec4 ink;
flat out vec2 line;                    // length, half width
noperspective out vec2 uv;

void main() {
    vec4 a = clip * vec4((from - eye) - eye_rest, 1.0), b = clip * vec4((to - eye) - eye_rest, 1.0);
    // What lies before the near plane (depth 1) is cut off here: nothing behind the eye has a place on the screen.
    float in_a = a.w - a.z, in_b = b.w - b.z;
    if (in_a < 0.0) a = mix(a, b, in_a / (in_a - in_b));
    if (in_b < 0.0) b = mix(b, a, in_b / (in_b - in_a));
    bool gone = in_a < 0.0 && in_b < 0.0;
    vec3 p = a.xyz / a.w, q = b.xyz / b.w;
    vec2 way = (q.xy - p.xy) * half_view;
    float len = length(way);
    vec2 along = len > 0.0 ? way / len : vec2(1.0, 0.0);
    float half_width = width * (pt / 64.0);
    float reach = half_width + 0.5;
    float side = corner >= 2.0 ? reach : -reach;
    bool at_end = mod(corner, 2.0) == 1.0;
    vec3 at = at_end ? q : p;
    vec2 go = along * (at_end ? reach : -reach) + vec2(-along.y, along.x) * side;
    gl_Position = gone ? vec4(0.0, 0.0, 2.0, 1.0) : vec4(at.xy + go / half_view, at.z, 1.0);
    ink = colour;
    line = vec2(len, half_width);
    uv = vec2(at_end ? len + reach : -reach, side);
}
)";

const char* const solid_edge_fragment_shader = R"(#version 330 core
flat in vec4 ink;
flat in vec2 line;
noperspective in vec2 uv;
out vec4 result;
void main() {
    float beyond = max(max(-uv.x, uv.x - line.x), 0.0);
    float d = length(vec2(beyond, uv.y));
    float share = clamp(min(line.y + 0.5 - d, 2.0 * line.y), 0.0, 1.0);
    result = vec4(ink.rgb, ink.a * share);
}
)";

}  // namespace sightline
