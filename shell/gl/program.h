// Compiling and linking shaders.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shell/gl/handles.h"

namespace sightline {

/// A linked program of GLSL 3.30 sources (with their #version line). Throws WorkError with the driver's words.
GlProgram make_program(const std::string& vertex, const std::string& fragment);

}  // namespace sightline
