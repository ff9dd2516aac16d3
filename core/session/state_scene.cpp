// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/state_scene.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/base/error.h"

namespace sightline {

namespace {

/// At most so many files beside a state file are read to find its scene by its hash.
constexpr std::size_t most_tried = 50;

/// Where a scene may lie that a state file names: there, beside the state file, or there under another name.
std::vector<std::string> places_of(const std::string& file, const std::string& state) {
    namespace fs = std::filesystem;
    std::error_code error;
    std::vector<std::string> places{file};
    const std::size_t hash = file.rfind('#');
    const fs::path path = file.substr(0, hash), folder = fs::path(state).parent_path();
    const std::string map = hash == std::string::npos ? "" : file.substr(hash);
    const auto add = [&](const fs::path& place) {
        const std::string name = place.string() + map;
        if (places.size() <= most_tried && fs::is_regular_file(place, error) &&
            std::find(places.begin(), places.end(), name) == places.end())
            places.push_back(name);
    };
    add(folder / path);
    add(folder / path.filename());
    if (path.extension().empty()) return places;
    std::vector<fs::path> others;
    for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end; at.increment(error))
        if (at->path().extension() == path.extension()) others.push_back(folder / at->path().filename());
    std::sort(others.begin(), others.end());
    for (const fs::path& other : others) add(other);
    return places;
}

}  // namespace

template <int D>
Scene<D> find_state_scene(const std::string& file, const std::string& hash, const std::string& state,
                          const LoadOptions& options) {
    std::string missing, wrong;
    for (const std::string& place : places_of(file, state)) {
        try {
            Scene<D> scene = load_scene<D>(place, options);
            if (hash_text(scene_hash(scene)) == hash) return scene;
            if (std::filesystem::path(place).filename() == std::filesystem::path(file).filename())
                wrong = "scene '" + scene.id + "' is not the one the state was made with (its hash differs)";
        } catch (const InputError& error) {
            if (missing.empty()) missing = error.what();
        }
    }
    throw InputError(wrong.empty() ? missing : wrong);
}

template Scene<2> find_state_scene<2>(const std::string&, const std::string&, const std::string&, const LoadOptions&);
template Scene<3> find_state_scene<3>(const std::string&, const std::string&, const std::string&, const LoadOptions&);

}  // namespace sightline
