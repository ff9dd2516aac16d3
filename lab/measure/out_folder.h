// Where results go when nobody says: folders named after what is measured, one for each study.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/measure/study.h"

namespace sightline::lab {

/// The scenes and paths of a study, for a name: "city", "city-street", "city-cars-and-3-more"; files by their names.
std::vector<std::string> name_parts(const Study& study);

/// "out/KIND-PART-PART"; empty parts are left out.
std::string folder_named(const std::string& kind, const std::vector<std::string>& parts);

/// `base`, or "base-2", "base-3" and so on: the first whose `checkpoint`, a file in it, is of this study or not there.
std::string folder_for(const std::string& base, const std::filesystem::path& checkpoint, const std::string& study);

}  // namespace sightline::lab
