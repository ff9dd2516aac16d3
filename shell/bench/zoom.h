// How much of the scene the picture shows. These are settings of the picture: undo knows them, state files keep them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/bench/workbench.h"

namespace sightline {

/// Magnifies by the factor; the scene point `fixed` stays where it is in the picture. Throws InputError for a factor
/// that is not above 0. Limits are those of the setting.
void zoom_about(Workbench<2>& bench, const Vec<2>& fixed, double factor, const std::string& gesture = "");

/// About the middle of what is shown.
void zoom(Workbench<2>& bench, double factor);

/// Puts this scene point into the middle of the picture.
void centre_on(Workbench<2>& bench, const Vec<2>& middle, const std::string& gesture = "");

/// Shows this box again, as the picture did before the scene's extent changed: what is drawn must not slip away from
/// under the hand that draws it.
void hold(Workbench<2>& bench, const Box<2>& world, const std::string& gesture = "");

/// Shows all again.
void fit(Workbench<2>& bench);

}  // namespace sightline
