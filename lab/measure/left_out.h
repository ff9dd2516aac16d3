// What a study asks for and cannot have.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "lab/measure/study.h"

namespace sightline::lab {

/// A line for each of the study's methods and kinds of budgets that do not go together, with the reason.
/// `times_drawing`: there is OpenGL, for scenes in 3D.
std::vector<std::string> left_out(const Study& study, bool times_drawing);

}  // namespace sightline::lab
