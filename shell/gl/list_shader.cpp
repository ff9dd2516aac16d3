// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/list_shader.h"

namespace sightline {

namespace {

std::string head(MeshRun::Kind kind) {
    std::string text = "#version 330 core\n";
    if (kind != MeshRun::Kind::lines) text += "#define FILLS\n";
    if (kind != MeshRun::Kind::fills) text += "#define LINES\n";
    if (kind == MeshRun::Kind::mixed) text += "#define MARKS\n";
    return text;
}

// Distances are pixels. `uv`: along a line from its start (a head: back from its tip), and to the left of it.
// The numbers of Paint and Hatch are those of their declarations.
constexpr const char* vertex_body = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 colour;
layout(location = 2) in vec4 second;
layout(location = 3) in vec2 length_start;
layout(location = 4) in vec2 half_width_size;
layout(location = 5) in vec2 direction;
layout(location = 6) in vec2 paint_corner;
uniform float scale;     // pixels to the scene unit
uniform vec2 shift;      // of the mesh's origin in the view
uniform vec2 half_view;
uniform float pt;        // pixels to the point of lines
flat out vec4 ink;
#ifdef FILLS
flat out vec4 hatch_ink;
#endif
#ifdef LINES
noperspective out vec2 uv;
#ifdef MARKS
flat out vec4 line;      // length, half width, start, size
#else
flat out vec2 line;
#endif
#endif
#if defined(FILLS) || defined(MARKS)
flat out vec2 kind;      // Paint; of a fill the Hatch
#endif

void main() {
    vec2 at = position * scale + shift;
    ink = colour;
#ifdef FILLS
    hatch_ink = second;
#endif
#if defined(FILLS) || defined(MARKS)
    kind = paint_corner;
#endif
#ifdef LINES
    vec2 along = direction * inversesqrt(max(dot(direction, direction), 1.0));
    float half_width = half_width_size.x * (pt / 64.0);
    float size = half_width_size.y * (pt / 64.0);
    float len = length_start.x * scale;
    float left = paint_corner.y >= 2.0 ? 1.0 : -1.0;
    bool at_end = mod(paint_corner.y, 2.0) == 1.0;
    float reach = half_width + 0.5;
    float side = left * reach;
#ifdef MARKS
    float paint = paint_corner.x;
    float back = 0.0;        // from the middle of a bar to its start
    if (paint == 4.0) {      // ring
        reach += size;
        side = left * reach;
    } else if (paint == 5.0) {  // bar
        len = size;
        back = 0.5 * size;
    } else if (paint == 6.0) {  // head
        len = size;
        reach = 1.0;
        side = left * (0.38 * size + 1.0);
    }
    float u = at_end ? len + reach : -reach;
    float go = at_end ? reach + back : -reach - back;
    if (paint == 6.0) go = -u;
    if (paint != 0.0) at += along * go + vec2(-along.y, along.x) * side;
    if (paint <= 3.0) len = max(len - size, 0.0);
#else
    float u = at_end ? len + reach : -reach;
    at += along * (at_end ? reach : -reach) + vec2(-along.y, along.x) * side;
#endif
    uv = vec2(u, side);
#ifdef MARKS
    line = vec4(len, half_width, length_start.y * scale, size);
#else
    line = vec2(len, half_width);
#endif
#endif
    gl_Position = vec4(at / half_view - 1.0, 0.0, 1.0);
}
)";

constexpr const char* fragment_body = R"(
flat in vec4 ink;
#ifdef FILLS
flat in vec4 hatch_ink;
#endif
#ifdef LINES
noperspective in vec2 uv;
#ifdef MARKS
flat in vec4 line;
#else
flat in vec2 line;
#endif
#endif
#if defined(FILLS) || defined(MARKS)
flat in vec2 kind;
#endif
uniform float pt;
uniform vec2 hatch;   // pitch, half width
uniform vec2 anchor;  // in the framebuffer
out vec4 result;

// The share of a pixel that a band takes whose middle is d away.
float band(float d, float half_width) { return clamp(min(half_width + 0.5 - d, 2.0 * half_width), 0.0, 1.0); }

#ifdef FILLS
// The distance to the nearest of parallel lines.
float nearest(float across, float pitch) { return abs(fract(across / pitch + 0.5) - 0.5) * pitch; }

float hatched(float pattern, vec2 at) {
    float pitch = hatch.x;
    // Rising lines, falling lines; horizontal ones take the place of rising ones.
    float rising = nearest(pattern == 4.0 ? at.y : (at.x - at.y) * 0.70710678, pitch);
    float falling = nearest((at.x + at.y) * 0.70710678, pitch);
    float d = pattern == 2.0 ? falling : pattern == 3.0 ? min(rising, falling) : rising;
    float row = floor(at.y / (pitch * 0.8660254) + 0.5);
    vec2 to_dot = vec2(nearest(at.x - 0.5 * pitch * mod(row, 2.0), pitch), at.y - row * pitch * 0.8660254);
    return pattern == 5.0 ? band(length(to_dot), pitch / 6.0) : band(d, hatch.y);
}
#endif

#ifdef MARKS
float dashes(float paint, float along, float across) {
    float width = max(2.0 * line.y, 0.75 * pt);
    float s = line.z + along;
    if (paint == 2.0) {
        float d = abs(mod(s - 1.75 * width + 3.0 * width, 6.0 * width) - 3.0 * width) - 1.75 * width;
        float end = max(-along, along - line.x);  // ends are cut straight
        return band(abs(across), line.y) * clamp(0.5 - max(d, end), 0.0, 1.0);
    }
    float period = 2.5 * width;
    float nearest_dot = floor(s / period + 0.5) * period - line.z;
    float d = length(vec2(along - nearest_dot, across));
    bool on_line = nearest_dot > -0.001 * period && nearest_dot < line.x + 0.001 * period;
    return on_line ? band(d, line.y) : 0.0;
}
#endif

void main() {
    float share = 1.0;
    result = ink;
#ifdef LINES
    float beyond = max(max(-uv.x, uv.x - line.x), 0.0);
    share = band(length(vec2(beyond, uv.y)), line.y);
#endif
#ifdef MARKS
    if (kind.x == 2.0 || kind.x == 3.0) share = dashes(kind.x, uv.x, uv.y);
    if (kind.x == 4.0) share = band(abs(length(uv) - line.w), line.y);
    if (kind.x == 6.0) share = clamp(0.5 - max((abs(uv.y) - 0.38 * uv.x) * 0.9348, uv.x - line.w), 0.0, 1.0);
    if (kind.x == 0.0) share = 1.0;
#endif
#ifdef FILLS
    // A transparent fill leaves only its hatch.
    float over = hatch_ink.a * hatched(kind.y, gl_FragCoord.xy - anchor);
#ifdef MARKS
    if (kind.x != 0.0) over = 0.0;
#endif
    float all = over + result.a * (1.0 - over);
    result = vec4((hatch_ink.rgb * over + result.rgb * (result.a * (1.0 - over))) / max(all, 0.001), all);
#endif
    result.a *= share;
}
)";

}  // namespace

std::string list_vertex_shader(MeshRun::Kind kind) { return head(kind) + vertex_body; }

std::string list_fragment_shader(MeshRun::Kind kind) { return head(kind) + fragment_body; }

}  // namespace sightline
