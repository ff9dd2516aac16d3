// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/portals/window.h"

#include <algorithm>
#include <cmath>

#include "core/base/number.h"

namespace sightline {

namespace {

/// Of half the image, in a window's sides: an eighth of a pixel of 1024. A reference may move a corner by less.
constexpr double snap = 0x1p-12;

bool is_within(const Vec<2>& eye, const Vec<2>& right, const Vec<2>& left, const Vec<2>& p) {
    return orient(eye, right, p) >= 0 && orient(eye, p, left) >= 0;
}

bool is_whole(const Window<3>& window) { return window.part.min == Vec<2>(-1) && window.part.max == Vec<2>(1); }

}  // namespace

Windows<3>::Windows(const View<3>& view) : view_(view), plane_(image_plane(view)) {
    farthest_ = 0;
    for (const Vec<3>& corner : view.corners) farthest_ = std::max(farthest_, glm::length(corner - view.eye));
}

Window<2> Windows<2>::whole() const { return {view_.corners[0], view_.corners[1], view_.all_round}; }
Window<3> Windows<3>::whole() const { return {{Vec<2>(-1), Vec<2>(1)}}; }

bool Windows<2>::covers(const Window<2>& outer, const Window<2>& inner) const {
    if (outer.all || inner.all) return outer.all;
    return is_within(view_.eye, outer.right, outer.left, inner.right) &&
           is_within(view_.eye, outer.right, outer.left, inner.left);
}
bool Windows<3>::covers(const Window<3>& outer, const Window<3>& inner) const {
    return outer.part.contains(inner.part.min) && outer.part.contains(inner.part.max);
}

/// Of two convex cones of directions the right border is that of them that lies in the other, and so is the left one.
Through Windows<2>::pass(const Window<2>& window, const Portal<2>& portal, const Vec<2>& near,
                         Window<2>& narrower) const {
    const Vec<2>& eye = view_.eye;
    Vec<2> right = portal.corners[0], left = portal.corners[1];
    const int side = orient(right, left, eye), wanted = orient(right, left, near);
    if (side * wanted < 0) return Through::behind;
    if (side == 0) return Through::beside;
    if (side < 0) std::swap(right, left);  // orient(eye, right, left) > 0
    narrower = {right, left, false};
    if (window.all) return Through::opens;
    if (!is_within(eye, window.right, window.left, right)) {
        if (!is_within(eye, right, left, window.right)) return Through::beside;
        narrower.right = window.right;
    }
    if (!is_within(eye, window.right, window.left, left)) {
        if (!is_within(eye, right, left, window.left)) return Through::beside;
        narrower.left = window.left;
    }
    return orient(eye, narrower.right, narrower.left) > 0 ? Through::opens : Through::beside;
}

/// The rectangle around the portal's projection. What lies nearer than `least` in depth is cut off first; an eye so
/// near to the portal's plane that this might show sees through all of the window.
Through Windows<3>::pass(const Window<3>& window, const Portal<3>& portal, const Vec<3>& near,
                         Window<3>& narrower) const {
    const auto& c = portal.corners;
    const int side = orient(c[0], c[1], c[2], view_.eye);
    if (side * orient(c[0], c[1], c[2], near) < 0) return Through::behind;
    std::vector<Vec<3>> seen;
    double deepest = 0;
    for (const Vec<3>& corner : c) {
        seen.push_back(plane_.project(corner));
        deepest = std::max(deepest, std::abs(seen.back().z));
    }
    const double least = 1e-6 * deepest;
    const Vec<3> normal = glm::cross(c[1] - c[0], c[2] - c[0]);
    const double away = std::abs(glm::dot(normal, view_.eye - c[0])) / glm::length(normal);
    if (away <= 4 * least * farthest_) {
        narrower = window;
        return Through::opens;
    }
    Box<2> box;
    const auto add = [&](const Vec<3>& p) { box.add({p.x / p.z, p.y / p.z}); };
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Vec<3>&a = seen[i], &b = seen[(i + 1) % seen.size()];
        if (a.z >= least) add(a);
        if ((a.z < least) != (b.z < least)) {
            const Vec<3> cut = a + (b - a) * ((least - a.z) / (b.z - a.z));
            add({cut.x, cut.y, least});
        }
    }
    if (box.empty()) return Through::beside;
    for (int i = 0; i < 2; ++i) {
        box.min[i] = std::max(window.part.min[i], box.min[i] - snap * std::max(1.0, std::abs(box.min[i])));
        box.max[i] = std::min(window.part.max[i], box.max[i] + snap * std::max(1.0, std::abs(box.max[i])));
        if (!(box.min[i] < box.max[i])) return Through::beside;
    }
    narrower.part = box;
    return Through::opens;
}

Window<2> Windows<2>::join(const Window<2>&, const Window<2>&) const { return whole(); }
Window<3> Windows<3>::join(const Window<3>& a, const Window<3>& b) const {
    Window<3> both = a;
    both.part.add(b.part);
    return both;
}

View<2> Windows<2>::view_of(const Window<2>& window) const {
    return window.all ? view_ : narrowed(view_, window.right, window.left);
}
View<3> Windows<3>::view_of(const Window<3>& window) const {
    return is_whole(window) ? view_ : narrowed(view_, window.part);
}

void add_window(Hash& hash, const Window<2>& window) {
    for (const double x : {window.right.x, window.right.y, window.left.x, window.left.y}) hash.add(x);
}
void add_window(Hash& hash, const Window<3>& window) {
    for (const double x : {window.part.min.x, window.part.min.y, window.part.max.x, window.part.max.y}) hash.add(x);
}

std::string window_words(const View<2>& view, const Window<2>& window) {
    if (window.all) return "all round";
    const Vec<2> right = window.right - view.eye, left = window.left - view.eye;
    constexpr double degrees = 57.29577951308232;
    return short_number(std::atan2(cross(right, left), glm::dot(right, left)) * degrees) + " degrees wide";
}
std::string window_words(const View<3>&, const Window<3>& window) {
    const Vec<2> size = window.part.extent();
    return short_number(25 * size.x * size.y) + " % of the image";
}

}  // namespace sightline
