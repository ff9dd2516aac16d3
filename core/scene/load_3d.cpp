// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/load.h"
#include "core/scene/text.h"

namespace sightline {

template <>
Scene<3> load_scene<3>(const std::string& name, const LoadOptions&) {
    throw input_error(name, "", "no such file, and no scene of the catalogue has this id");
}

}  // namespace sightline
