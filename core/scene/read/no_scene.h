// What is said of a name that is neither a file nor a scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/scene/make/catalogue.h"

namespace sightline {

/// With the scene that was most likely meant.
template <int D>
InputError no_scene(const std::string& name) {
    std::vector<std::string_view> known;
    for (const CatalogueRow<D>& row : catalogue<D>()) known.emplace_back(row.id);
    for (const CatalogueRow<D>& row : failure_scenes<D>()) known.emplace_back(row.id);
    const std::string_view meant = closest(name, known);
    const std::string hint = meant.empty() ? "" : "; did you mean " + std::string(meant) + "?";
    return input_error(name, "", "no such file, and no scene of the catalogue has this id" + hint);
}

}  // namespace sightline
