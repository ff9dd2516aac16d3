// Everything a person can choose, in one plain struct. It feeds the command line, JSON files, panels and reports; each
// field has one name, one default and one line of help (settings_table.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/image_size.h"
#include "core/run/budget.h"
#include "core/run/parameters.h"
#include "core/scene/reading.h"
#include "core/session/picture_settings.h"
#include "core/space/tessellation.h"
#include "core/truth/reference_by.h"

namespace sightline {

struct Settings : TessellationSettings, PictureSettings {
    Switch two_sided = Switch::off;
    Up up = Up::automatic;
    Degrees degrees = Degrees::as_is;
    /// `auto`: method, cells and budget are those that are recommended for the scene (shell/desk/auto_choice.h).
    Switch automatic = Switch::off;
    /// An id of the method table, or a variant: "published on_reenqueue=min". A session splits the variant up: its
    /// assignments go to `parameters`, and the id stays.
    std::string method = "published";
    Budget budget;
    Parameters parameters;  ///< of methods: what differs from their defaults
    ImageSize reference_size;
    ReferenceBy reference = ReferenceBy::opengl;

    bool operator==(const Settings&) const = default;
};

}  // namespace sightline
