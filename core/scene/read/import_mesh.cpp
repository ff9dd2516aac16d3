// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/import_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/scene/read/file_kind.h"
#include "core/scene/read/other_formats.h"
#include "core/scene/read/read_gltf.h"
#include "core/scene/read/read_obj.h"
#include "core/scene/read/read_off.h"
#include "core/scene/read/read_ply.h"
#include "core/scene/read/read_stl.h"

namespace sightline {

namespace {

constexpr std::string_view gltf_endings[] = {".gltf", ".glb", ".vrm"};

bool is_gltf(const std::string& ending) {
    return std::find(std::begin(gltf_endings), std::end(gltf_endings), ending) != std::end(gltf_endings);
}

struct OwnFormat {
    std::string_view ending;
    ParsedMesh (*read)(std::string_view bytes, const ShareDone& progress);
    int up_axis;
};
constexpr OwnFormat own_formats[] = {
    {".obj", read_obj, 1}, {".ply", read_ply, 2}, {".stl", read_stl, 2}, {".off", read_off, 2}};

const OwnFormat* own_format(const std::string& ending) {
    for (const OwnFormat& format : own_formats)
        if (ending == format.ending) return &format;
    return nullptr;
}

/// ".3d, .3ds, ..."
std::string mesh_endings() {
    std::set<std::string> endings = other_endings();
    for (const OwnFormat& format : own_formats) endings.emplace(format.ending);
    endings.insert(std::begin(gltf_endings), std::end(gltf_endings));
    std::string list;
    for (const std::string& ending : endings) list += (list.empty() ? "" : ", ") + ending;
    return list;
}

void check_ending(const std::string& path, const std::string& name, const std::string& place) {
    const std::string ending = ending_of(path);
    if (is_mesh_ending(ending)) return;
    const std::string what =
        ending.empty() ? "its name has no extension" : one_line(ending, 20) + " is not the extension of a 3D format";
    throw input_error(name, place, with_kind(what, path) + "; supported: " + mesh_endings());
}

ImportedFile import_own(const OwnFormat& format, const std::string& path, const std::string& name,
                        const std::string& place, Scene<3>& scene, const ShareDone& progress) {
    ParsedMesh mesh;
    try {
        const std::string bytes = read_file(path, std::numeric_limits<std::uint64_t>::max());
        progress(0.1);
        mesh = format.read(bytes, [&](double share) { progress(0.1 + 0.9 * share); });
    } catch (const InputError& error) {
        std::string_view reason = error.what();
        if (reason.starts_with(path + ": ")) reason.remove_prefix(path.size() + 2);
        throw input_error(name, place, with_kind(std::string(reason), path));
    } catch (const std::bad_alloc&) {
        throw input_error(name, place, "needs more memory than there is");
    }
    const std::size_t before = scene.primitives.size();
    if (before == 0)
        scene.primitives = std::move(mesh.triangles);
    else
        scene.primitives.insert(scene.primitives.end(), mesh.triangles.begin(), mesh.triangles.end());
    if (!scene.two_sided.empty()) scene.two_sided.resize(scene.primitives.size());
    if (!mesh.objects.empty()) {
        Objects& objects = scene.objects;
        const auto first = static_cast<std::uint32_t>(objects.names.size());
        objects.of.resize(before);
        for (const std::uint32_t object : mesh.objects.of) objects.of.push_back(first + object);
        objects.names.insert(objects.names.end(), mesh.objects.names.begin(), mesh.objects.names.end());
    }
    for (const std::string& warning : mesh.warnings)
        scene.warnings.push_back((place.empty() ? "" : place + ": ") + one_line(warning));
    if (mesh.single_precision) warn_of_steps(scene, before, place);
    ImportedFile file{std::string(format.ending.substr(1)), format.up_axis, {}};
    file.names_up = false;
    return file;
}

}  // namespace

void warn_of_steps(Scene<3>& scene, std::size_t first, const std::string& place) {
    Box<3> box;
    for (std::size_t i = first; i < scene.primitives.size(); ++i)
        for (const Vec<3>& corner : scene.primitives[i])
            if (is_finite(corner)) box.add(corner);
    if (box.empty()) return;
    double far = 0;
    for (int axis = 0; axis < 3; ++axis) far = std::max({far, -box.min[axis], box.max[axis]});
    if (far * 0x1p-24 <= 1e-4 * box.longest_side()) return;
    const auto size = static_cast<float>(far);
    const double step = static_cast<double>(size) - static_cast<double>(std::nextafter(size, 0.0f));
    scene.warnings.push_back((place.empty() ? "" : place + ": ") +
                             "lies so far from zero that its coordinates, read as " + "floats, are in steps of " +
                             short_number(step));
}

ImportedFile import_mesh(const std::string& path, const std::string& name, const std::string& place, Scene<3>& scene,
                         const std::function<void(double share)>& progress) {
    check_ending(path, name, place);
    const std::string ending = ending_of(path);
    if (const OwnFormat* const format = own_format(ending))
        return import_own(*format, path, name, place, scene, progress);
    if (is_gltf(ending)) {
        progress(0.1);
        if (std::optional<ImportedFile> file = read_gltf(path, name, place, scene)) return *std::move(file);
    }
    return import_other(path, name, place, scene, progress);
}

bool is_mesh_ending(const std::string& ending) {
    return own_format(ending) || is_gltf(ending) || is_other_ending(ending);
}

}  // namespace sightline
