// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/out_folder.h"

#include <algorithm>

#include "lab/measure/checkpoint.h"
#include "lab/report/chart.h"

namespace sightline::lab {

namespace fs = std::filesystem;

namespace {

/// A file by its name alone, without its ending.
std::string part_of(const std::string& name) {
    std::error_code error;
    return fs::exists(name, error) ? fs::path(name).stem().string() : name;
}

void add(std::vector<std::string>& parts, const std::vector<std::string>& names) {
    constexpr std::size_t most = 3;
    const std::size_t shown = names.size() > most ? most - 1 : names.size();
    parts.insert(parts.end(), names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown));
    if (shown < names.size()) parts.push_back("and-" + std::to_string(names.size() - shown) + "-more");
}

}  // namespace

std::vector<std::string> name_parts(const Study& study) {
    std::vector<std::string> parts, scenes, paths;
    for (const std::string& scene : study.scenes) scenes.push_back(part_of(scene));
    for (const std::string& path : study.paths)
        if (!path.empty()) paths.push_back(part_of(path));
    add(parts, scenes);
    add(parts, paths);
    return parts;
}

std::string folder_named(const std::string& kind, const std::vector<std::string>& parts) {
    std::string name = kind;
    for (const std::string& part : parts)
        if (!part.empty()) name += "-" + part;
    return "out/" + file_stem(name);
}

std::string folder_for(const std::string& base, const fs::path& checkpoint, const std::string& study) {
    std::error_code error;
    for (int number = 1;; ++number) {
        const std::string folder = number == 1 ? base : base + "-" + std::to_string(number);
        const fs::path file = folder / checkpoint;
        if (!fs::is_regular_file(file, error) || checkpoint_study(file) == study) return folder;
    }
}

}  // namespace sightline::lab
