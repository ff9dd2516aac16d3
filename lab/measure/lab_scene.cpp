// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/lab_scene.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/base/number.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/base/trig.h"
#include "core/methods/listed/listed.h"
#include "core/scene/read/load.h"
#include "core/scene/scene_view.h"
#include "core/session/settings_table.h"
#include "core/session/start_settings.h"
#include "core/space/builders.h"

namespace sightline::lab {

namespace {

constexpr int turn_frames = 8;

/// The direction turned about the scene's up axis (2D: about the eye).
Vec<2> turned(const Vec<2>& d, const SinCos& by, const Scene<2>&) {
    return {by.cos * d.x - by.sin * d.y, by.sin * d.x + by.cos * d.y};
}
Vec<3> turned(const Vec<3>& d, const SinCos& by, const Scene<3>& scene) {
    const int up = scene.up_axis, a = (up + 1) % 3, b = (up + 2) % 3;
    Vec<3> result = d;
    result[a] = by.cos * d[a] - by.sin * d[b];
    result[b] = by.sin * d[a] + by.cos * d[b];
    return result;
}

template <int D>
Settings settings_of(const std::string& file, const Study& study) {
    Settings settings = catalogue_settings<D>(file);
    settings.budget = {};
    for (const std::string& assignment : study.settings) apply_setting(settings, assignment);
    settings.reference_size = study.size;
    return settings;
}

template <int D>
Scene<D> load(const std::string& file, const Settings& settings, const Progress& progress) {
    return load_scene<D>(file, read_options(settings, progress));
}

/// A frame that a listed set lacks would be measured as one in which nothing was rendered.
template <int D>
void check_sets(LabScene<D>& lab, const Study& study) {
    Hash hash;
    bool any = false;
    for (const MethodChoice& choice : study.methods) {
        if (choice.id() != listed_id || !method_of<D>(lab.tables, choice)) continue;
        const Variant<D> variant = lab.variant_for(choice);
        for (std::size_t i = 0; i < lab.views.size(); ++i)
            if (const std::string why = listed_lacks<D>(make_problem(variant.method, variant.parameters, *lab.scene,
                                                                     lab.on(choice.tessellation), lab.views[i]));
                !why.empty())
                throw InputError(excerpt(lab.name) + ", path " + excerpt(lab.path) + ", frame " +
                                 std::to_string(lab.frames[i]) + ": " + why);
        hash.add(listed_hash(variant.parameters));
        any = true;
    }
    if (any) lab.listed = hash.value();
}

}  // namespace

template <int D>
FlightPath<D> find_path(const Scene<D>& scene, const std::string& name) {
    std::error_code error;
    if (const std::optional<PathPart> part = part_of_path(name); part && !std::filesystem::exists(name, error)) {
        FlightPath<D> path = find_path<D>(scene, part->path);
        const std::size_t count = path.frames.size();
        if (part->last >= count)
            throw InputError("path '" + excerpt(name) + "': " + excerpt(part->path) + " has frames 0 to " +
                             std::to_string(count - 1));
        const auto begin = path.frames.begin();
        path.frames = {begin + part->first, begin + part->last + 1};
        return path;
    }
    const auto of_scene = [&](const std::string& id) -> const FlightPath<D>* {
        for (const FlightPath<D>& path : scene.paths)
            if (path.id == id) return &path;
        return nullptr;
    };
    if (const FlightPath<D>* path = of_scene(name.empty() ? "test" : name)) return *path;
    if (name.empty() || name == "turn" || name == "start") {
        ViewSpec<D> view;
        view.look_at.x = 1;
        if (scene.start_view) view = *scene.start_view;
        FlightPath<D> path{name == "start" ? "start" : "turn", {}, {}, {}};
        for (int i = 0; i < (name == "start" ? 1 : turn_frames); ++i) {
            path.frames.push_back(view);
            path.frames.back().look_at =
                view.eye + turned(view.look_at - view.eye, sincos_degrees(360.0 * i / turn_frames), scene);
        }
        return path;
    }
    if (!std::filesystem::exists(name, error)) {
        std::string known = "turn, start";
        for (const FlightPath<D>& path : scene.paths) known += ", " + excerpt(path.id);
        throw InputError("path '" + excerpt(name) + "': neither a file nor a path of " + excerpt(scene.id) +
                         ", which has " + known);
    }
    FlightPath<D> path = read_path<D>(read_file(name), name);
    set_origin(path, scene.origin);
    return path;
}

template <int D>
void check_scene(const std::string& name, const std::vector<std::string>& paths, const Study& study) {
    const std::string file = parse_scene(name).name;
    const Scene<D> scene = load<D>(file, settings_of<D>(file, study), {});
    for (const std::string& path : paths) find_path(scene, path);
}

template <int D>
LabScene<D> load_lab_scene(const std::string& name, const std::string& path_name, const Study& study,
                           const Progress& progress) {
    LabScene<D> lab;
    lab.name = name;
    lab.tables = study.tables;
    const std::string file = parse_scene(name).name;
    lab.settings = settings_of<D>(file, study);
    lab.scene = std::make_shared<const Scene<D>>(load<D>(file, lab.settings, progress));

    const FlightPath<D> path = find_path(*lab.scene, path_name);
    lab.path = path_name.empty() ? path.id : path_name;
    const std::size_t wanted = study.frames == 0 ? path.frames.size() : study.frames;
    for (const std::size_t frame : spread_frames(path.frames.size(), wanted)) {
        lab.frames.push_back(static_cast<std::uint32_t>(frame));
        lab.specs.push_back(path.frames[frame]);
        lab.views.push_back(scene_view(path.frames[frame], *lab.scene, study.size));
        lab.before.emplace_back();
        if (frame > 0) lab.before.back() = scene_view(path.frames[frame - 1], *lab.scene, study.size);
    }
    for (const MethodChoice& choice : study.methods) {
        auto& cells = lab.cells[static_cast<std::size_t>(choice.tessellation)];
        if (cells) continue;
        const Stopwatch stopwatch;
        cells = build_cells(*lab.scene, lab.settings_for(choice));
        lab.build_seconds[static_cast<std::size_t>(choice.tessellation)] = stopwatch.milliseconds() / 1000;
    }
    check_sets(lab, study);
    return lab;
}

template <int D>
std::string checkpoint_key(const LabScene<D>& lab) {
    Hash hash;
    hash.add(scene_hash(*lab.scene));
    for (const std::uint8_t two_sided : lab.scene->two_sided) hash.add(two_sided);
    for (const ViewSpec<D>& view : lab.specs) {
        for (int i = 0; i < D; ++i) {
            hash.add(view.eye[i]);
            hash.add(view.look_at[i]);
        }
        hash.add(view.fov);
    }
    if (lab.listed != 0) hash.add(lab.listed);
    return lab.name + ", path " + lab.path + ", error bound " + number_text(lab.settings.error_bound) + ", " +
           hash_text(hash.value());
}

#define SIGHTLINE_INSTANTIATE(D)                                                                     \
    template FlightPath<D> find_path<D>(const Scene<D>&, const std::string&);                        \
    template void check_scene<D>(const std::string&, const std::vector<std::string>&, const Study&); \
    template std::string checkpoint_key<D>(const LabScene<D>&);                                      \
    template LabScene<D> load_lab_scene<D>(const std::string&, const std::string&, const Study&, const Progress&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
