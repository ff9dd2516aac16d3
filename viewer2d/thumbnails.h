// Small pictures of 2D scenes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/pane/thumbnails.h"

namespace sightline {

/// A scene of the catalogue at the end of its run, the segments alone of others.
Thumbnails::Make thumbnails2d();

}  // namespace sightline
