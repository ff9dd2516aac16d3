// Small pictures of 3D scenes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/pane/thumbnails.h"

namespace sightline {

/// The scene at its smallest size, from its start view.
Thumbnails::Make thumbnails3d();

}  // namespace sightline
