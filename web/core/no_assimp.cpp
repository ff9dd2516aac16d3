// Without Assimp: the formats that have a reader of the project's own are all there are.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/scene/read/file_kind.h"
#include "core/scene/read/other_formats.h"

namespace sightline {

ImportedFile import_other(const std::string& path, const std::string& name, const std::string& place, Scene<3>&,
                          const std::function<void(double share)>&) {
    throw input_error(name, place, with_kind("is not what this page reads of " + ending_of(path), path));
}

bool is_other_ending(const std::string&) { return false; }

std::set<std::string> other_endings() { return {}; }

}  // namespace sightline
