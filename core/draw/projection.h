// From three dimensions to the plane of a picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/scene/view.h"

namespace sightline {

/// The plane of a 3D picture: x right, y up, in heights of the picture; from (0, 0) to (width / height, 1).
Box<2> picture_plane(const View<3>& view);

/// Distance from the eye along the direction in which it looks, in distances to look_at; negative behind the eye.
double depth(const View<3>& view, const Vec<3>& p);

/// Where the view shows a point, also beside the picture; nothing for points that do not lie before the eye.
std::optional<Vec<2>> project(const View<3>& view, const Vec<3>& p);

/// A line as the view shows it. Cut where it passes the eye, and well outside the picture.
struct ProjectedLine {
    Vec<2> a, b;
    bool to_the_end = true;  ///< b is the line's own end
};

/// Nothing when no part of the line lies before the eye and near the picture.
std::optional<ProjectedLine> project_line(const View<3>& view, const Vec<3>& a, const Vec<3>& b);

}  // namespace sightline
