// What an eye in the plane sees, as a strip under the plan: one row of pixels, exact above, as drawn so far below.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/draw/draw_list.h"
#include "core/draw/palette.h"
#include "core/session/session.h"

namespace sightline {

/// The row of pixels of the culling view, as wide as the reference; pixel 0 is at the left border of the view.
struct EyeStrip {
    /// Neighbouring pixels that show the same.
    struct Piece {
        int begin = 0, end = 0;
        std::uint32_t exact = none, drawn = none;  ///< segments; none: nothing is there
        bool operator==(const Piece&) const = default;
    };
    std::vector<Piece> pieces;  ///< from left to right, without gaps
    int pixels = 0;
    int wrong = 0;           ///< pixels at which the two differ
    bool concealed = false;  ///< what is visible is not told: exact is none everywhere, and nothing is wrong

    bool is_wrong(const Piece& piece) const { return !concealed && piece.exact != piece.drawn; }
    const Piece& at(int pixel) const;
};

EyeStrip eye_strip(const Session<2>& session);

/// From the eye towards the middle of a pixel of the strip.
Vec<2> through_pixel(const View<2>& view, int pixels, int pixel);

/// [begin, end) of the wrong pixels that lie beside each other, from left to right.
std::vector<std::array<int, 2>> wrong_stretches(const EyeStrip& strip);

/// Where the strip lies, in scene units. Between its two bands wrong pixels are marked; `top` is the upper border of
/// its paper, which reaches down to the lower border of the picture and has the words of the strip on it.
struct EyeStripPlace {
    double left = 0, right = 0;
    double drawn_low = 0, drawn_high = 0, exact_low = 0, exact_high = 0, top = 0;

    /// Of the left border of a pixel.
    double x_of(int pixel, int pixels) const { return left + (right - left) * pixel / pixels; }
    /// [left, right] of the mark of wrong pixels: wide enough to be seen, however few they are.
    std::array<double, 2> mark_of(const std::array<int, 2>& stretch, int pixels) const;
};

/// `over_depths`: the strip of depths lies under it.
EyeStripPlace eye_strip_place(const Box<2>& world, bool over_depths);

/// By how much a picture of this part of the scene has to reach further down, so that the strip hides nothing of it.
double eye_strip_room(const Box<2>& shown, bool over_depths);

/// Draws it on paper over the lower border of the list's world, and the selected segment outlined in it.
void add_eye_strip(const Session<2>& session, const EyeStrip& strip, const Colours& colours, DrawList& list);

}  // namespace sightline
