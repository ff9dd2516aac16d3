// How dense the pixels of a window's screen are.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <SDL_video.h>

namespace sightline {

/// How many times the usual 96 dots per inch the screen has, in quarters: what the desktop is set to, else what the
/// screen says of itself; 1 where neither says anything that makes sense.
double screen_density(SDL_Window* window);

}  // namespace sightline
