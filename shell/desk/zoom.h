// How much of the scene the picture shows. In 2D these are settings of the picture: undo knows them, state files keep
// them. In 3D it is the display view that moves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"

namespace sightline {

/// Magnifies by the factor; the scene point `fixed` stays where it is in the picture. Throws InputError for a factor
/// that is not above 0. Limits are those of the setting.
void zoom_about(Workbench<2>& bench, const Vec<2>& fixed, double factor, const std::string& gesture = "");

/// About the middle of what is shown. In 3D the eye of the display view comes nearer to what it looks at.
template <int D>
void zoom(Workbench<D>& bench, double factor);

/// Moves over the scene by shares of what the picture shows, x right, y up. In 3D the display view moves sideways.
template <int D>
void pan(Workbench<D>& bench, const Vec<2>& shares);

/// Puts this scene point into the middle of the picture.
void centre_on(Workbench<2>& bench, const Vec<2>& middle, const std::string& gesture = "");

/// Shows this box again, as the picture did before the scene's extent changed: what is drawn must not slip away from
/// under the hand that draws it.
void hold(Workbench<2>& bench, const Box<2>& world, const std::string& gesture = "");

/// Shows all again; in 3D the display view looks at all of the scene from outside.
template <int D>
void fit(Workbench<D>& bench);

/// The box of the selected primitive, box of a tree or cell. Throws InputError when nothing of that kind is selected.
template <int D>
Box<D> box_of_selection(const Workbench<D>& bench);

/// The selection in the middle of the picture, about three times as wide as itself; in 3D the display view alone moves
/// (the culling view is frozen first, so that the run stays), and circling then goes about the selection.
template <int D>
void fit_selection(Workbench<D>& bench);

}  // namespace sightline
