// Moving a view in 3D: turning, walking, circling. Of views alone; whoever moves one says which view it is.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

namespace sightline {

/// Unit vectors of a view: where it looks, and right and up of its picture.
struct Axes {
    Vec<3> forward, right, up;
};
Axes axes(const ViewSpec<3>& view, int up_axis);

/// About look_at, by degrees: `right` moves the eye to its right, `up` upwards, never over the pole.
ViewSpec<3> orbited(const ViewSpec<3>& view, int up_axis, double right, double up);

/// On the spot, by degrees; never past straight up or down.
ViewSpec<3> turned(const ViewSpec<3>& view, int up_axis, double right, double up);

/// Eye and look_at together, in scene units along the axes of the view.
ViewSpec<3> walked(const ViewSpec<3>& view, int up_axis, const Vec<3>& right_up_forward);

/// The eye nearer to look_at (factor > 1) or away from it.
ViewSpec<3> approached(const ViewSpec<3>& view, double factor);

/// The same direction from where the whole box is in the picture, about its middle; `aspect` is width / height.
ViewSpec<3> outside(const ViewSpec<3>& view, const Box<3>& box, int up_axis, double aspect);

}  // namespace sightline
