// What an eye sees through portals: an interval of directions in 2D, a rectangle of the image in 3D.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/hash.h"
#include "core/raster/image_plane.h"
#include "core/scene/view.h"

namespace sightline {

template <int D>
struct Window;
/// Directions counter-clockwise from that to `right` to that to `left`, less than half a turn; all: every one.
template <>
struct Window<2> {
    Vec<2> right{}, left{};
    bool all = false;
};
/// As ImagePlane has it.
template <>
struct Window<3> {
    Box<2> part;
};

/// How a portal is seen through a window.
enum class Through : std::uint8_t { opens, behind, beside };

/// The windows of one view.
template <int D>
class Windows;

/// Exact; what is seen at no angle does not count.
template <>
class Windows<2> {
public:
    Windows() = default;
    explicit Windows(const View<2>& view) : view_(view) {}

    Window<2> whole() const;
    /// Whether all that is seen through `inner` is seen through `outer`.
    bool covers(const Window<2>& outer, const Window<2>& inner) const;
    /// What of the window the portal leaves, seen from the side on which `near` lies (a point strictly on one of them).
    Through pass(const Window<2>& window, const Portal<2>& portal, const Vec<2>& near, Window<2>& narrower) const;
    /// One that covers both.
    Window<2> join(const Window<2>& a, const Window<2>& b) const;
    View<2> view_of(const Window<2>& window) const;

private:
    View<2> view_;
};

/// Never too small, also for images whose triangles are snapped to parts of a pixel.
template <>
class Windows<3> {
public:
    Windows() = default;
    explicit Windows(const View<3>& view);

    Window<3> whole() const;
    /// Whether all that is seen through `inner` is seen through `outer`.
    bool covers(const Window<3>& outer, const Window<3>& inner) const;
    /// What of the window the portal leaves, seen from the side on which `near` lies (a point strictly on one of them).
    Through pass(const Window<3>& window, const Portal<3>& portal, const Vec<3>& near, Window<3>& narrower) const;
    /// One that covers both.
    Window<3> join(const Window<3>& a, const Window<3>& b) const;
    View<3> view_of(const Window<3>& window) const;

private:
    View<3> view_;
    ImagePlane plane_;
    double farthest_ = 1;  ///< from the eye to a corner
};

void add_window(Hash& hash, const Window<2>& window);
void add_window(Hash& hash, const Window<3>& window);
/// As a person reads it: the angle, or the share of the image.
std::string window_words(const View<2>& view, const Window<2>& window);
std::string window_words(const View<3>& view, const Window<3>& window);

}  // namespace sightline
