// What a scene starts with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/scene/read/load.h"
#include "core/session/settings.h"

namespace sightline {

/// The catalogue row's settings, method and budget, or the defaults for a name that is not in the catalogue.
template <int D>
Settings catalogue_settings(const std::string& name);

/// What the settings say of reading a scene.
LoadOptions read_options(const Settings& settings, const Progress& progress = {});

}  // namespace sightline
