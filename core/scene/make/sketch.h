// Inside core/scene: drawing floor plans out of segments. Uses only + - * / and sqrt, so that scenes are the same bits
// on every machine.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/random.h"
#include "core/base/trig.h"
#include "core/scene/scene.h"

namespace sightline {

/// Local coordinates: turned by an angle, then moved.
struct Placement {
    Vec<2> origin{};
    double cos = 1, sin = 0;

    Vec<2> at(const Vec<2>& p) const { return {origin.x + cos * p.x - sin * p.y, origin.y + sin * p.x + cos * p.y}; }
};
Placement turned(const Vec<2>& origin, double degrees);

/// A gap in a wall; `at` is the distance of its middle from the wall's first end.
struct Opening {
    double at, width;
};

/// Segments so far and the frame in which the next ones are given.
struct Sketch {
    std::vector<Primitive<2>> segments;
    Placement frame;

    void line(const Vec<2>& a, const Vec<2>& b) { segments.push_back({frame.at(a), frame.at(b)}); }
    void path(std::span<const Vec<2>> points, bool closed);
    void path(std::initializer_list<Vec<2>> points, bool closed) {
        path(std::span(points.begin(), points.size()), closed);
    }
    void box(double x0, double y0, double x1, double y1);
    /// A regular polygon; degrees turns its first corner.
    void ring(const Vec<2>& centre, double radius, int corners, double degrees = 0);
    /// A straight wall with gaps, which must be in order and not overlap.
    void wall(const Vec<2>& a, const Vec<2>& b, std::span<const Opening> openings = {});
};

/// A rectangle between walls, in the sketch's frame.
struct RoomPlan {
    double x0, y0, x1, y1;
    double width() const { return x1 - x0; }
    double depth() const { return y1 - y0; }
};

enum class Furnishing { living, office, storage };

/// Furniture that fits the room, well inside it; nothing when it is too small. Lengths are metres.
void furnish(Sketch& sketch, Random& random, const RoomPlan& room, Furnishing furnishing);

void tree(Sketch& sketch, Random& random, const Vec<2>& centre, double radius);
void crate(Sketch& sketch, Random& random, const Vec<2>& centre, double side);

struct HouseStyle {
    bool openings = true;   ///< doors and windows in the outer walls; else the outline is closed
    bool furniture = true;  ///< else only inner walls
    double smallest_room = 3;
};

/// A house with its front on the local line y = 0 from x = 0 to width, going back to y = depth: outer walls, rooms
/// divided by walls with doors, furniture. No two of its segments cross.
void house(Sketch& sketch, Random& random, double width, double depth, const HouseStyle& style);

}  // namespace sightline
