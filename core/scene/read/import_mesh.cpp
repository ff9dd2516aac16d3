// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/import_mesh.h"

#include <algorithm>
#include <assimp/Importer.hpp>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>
#include <string_view>

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/scene/read/assimp_reader.h"
#include "core/scene/read/file_kind.h"
#include "core/scene/read/read_gltf.h"
#include "core/scene/read/read_obj.h"
#include "core/scene/read/read_off.h"
#include "core/scene/read/read_ply.h"
#include "core/scene/read/read_stl.h"

namespace sightline {

namespace {

namespace fs = std::filesystem;

/// Bytes of the file and of what glTF keeps beside it.
double bytes_to_read(const fs::path& path) {
    std::error_code no_error;
    double bytes = static_cast<double>(fs::file_size(path, no_error));
    if (ending_of(path.string()) != ".gltf") return bytes;
    for (const fs::directory_entry& beside :
         fs::directory_iterator(path.parent_path().empty() ? "." : path.parent_path(), no_error))
        if (beside.path().extension() == ".bin" && beside.is_regular_file(no_error))
            bytes += static_cast<double>(beside.file_size(no_error));
    return bytes;
}

/// Readers do 20 to 60 MB a second and take 3 to 7 bytes for each (Assimp 5.2). Compressed formats
/// take more; files that lie about their size must not take the machine down, nor go on for ever.
double usual_seconds(double bytes) { return 0.5 + bytes / 20e6; }
double most_seconds(double bytes) { return 10 + bytes / 2e5; }
double most_memory(double bytes) { return 2e9 + 50 * bytes; }

/// Assimp's words, where they help nobody, in better ones.
std::string reason_of(const std::string& words) {
    if (words.find("bad_alloc") != std::string::npos) return "needs far more memory than its size suggests";
    if (words.starts_with("No suitable reader")) return "is not a 3D file that Assimp can read";
    return words.empty() ? "Assimp cannot read it" : words;
}

/// Where the file holds another format than its ending says, people look for the mistake there.
std::string with_kind(const std::string& reason, const std::string& path) {
    const std::string kind = kind_behind(path);
    return kind.empty() ? reason : reason + " (it begins like " + kind + ")";
}

/// Of formats of Assimp that hold movement and no triangles; their readers take any text, or make up bones.
constexpr std::string_view no_mesh[] = {".bvh", ".csm", ".md5anim", ".md5camera", ".mot", ".vta"};

/// ".3d, .3ds, ..."
std::string mesh_endings() {
    std::string globs;
    Assimp::Importer().GetExtensionList(globs);  // "*.3d;*.3ds"
    std::set<std::string> endings;
    std::istringstream words(globs);
    for (std::string glob; std::getline(words, glob, ';');)
        if (is_mesh_ending(glob.substr(1))) endings.insert(glob.substr(1));
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

bool is_gltf(const std::string& path) {
    for (const std::string_view ending : {".gltf", ".glb", ".vrm"})
        if (ending_of(path) == ending) return true;
    return false;
}

struct OwnFormat {
    std::string_view ending;
    ParsedMesh (*read)(std::string_view bytes, const ShareDone& progress);
    int up_axis;
};
constexpr OwnFormat own_formats[] = {
    {".obj", read_obj, 1}, {".ply", read_ply, 2}, {".stl", read_stl, 2}, {".off", read_off, 2}};

/// Floats are apart by 2^-24 of their size: where that shows, in the scene from triangle `first` on, people should
/// know.
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

ImportedFile import_with_assimp(const std::string& path, const std::string& name, const std::string& place,
                                Scene<3>& scene, const ShareDone& progress) {
    const double bytes = bytes_to_read(path);
    ChildProcess child([&](const ChildProcess::Send& send) { read_with_assimp(path, send); }, most_seconds(bytes),
                       most_memory(bytes));

    const auto start = std::chrono::steady_clock::now();
    double share = 0;
    const auto tick = [&] {
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        share = std::max(share, 0.9 * seconds.count() / (seconds.count() + usual_seconds(bytes)));
        progress(share);
    };
    const auto receive = [&](void* to, std::size_t size) {
        if (!child.read(to, size, tick))
            throw input_error(name, place, with_kind("the reader (Assimp) " + child.end(), path));
    };
    AssimpHeader header;
    receive(&header, sizeof header);
    if (header.failed) throw input_error(name, place, with_kind(reason_of(header.text), path));

    const std::size_t before = scene.primitives.size();
    scene.primitives.resize(before + header.triangles);
    constexpr std::size_t most = std::size_t{1} << 17;
    const double begin = share;
    for (std::size_t done = 0; done < header.triangles;) {
        const std::size_t count = std::min(most, header.triangles - done);
        receive(&scene.primitives[before + done], count * sizeof(Primitive<3>));
        done += count;
        share = begin + (1 - begin) * static_cast<double>(done) / static_cast<double>(header.triangles);
        progress(share);
    }
    if (header.any_two_sided || !scene.two_sided.empty()) scene.two_sided.resize(scene.primitives.size());
    if (header.any_two_sided) receive(&scene.two_sided[before], header.triangles);
    if (header.objects > 1) {
        scene.objects.of.resize(before);
        for (std::uint64_t i = 0; i < header.objects; ++i) {
            AssimpObject object;
            receive(&object, sizeof object);
            scene.objects.of.resize(scene.objects.of.size() + object.triangles,
                                    static_cast<std::uint32_t>(scene.objects.names.size()));
            scene.objects.names.emplace_back(object.name);
        }
    }

    warn_of_steps(scene, before, place);
    if (header.warning[0]) scene.warnings.push_back((place.empty() ? "" : place + ": ") + one_line(header.warning));
    ImportedFile file{header.text, header.up_axis, {}};
    file.names_up = header.names_up;
    if (header.has_camera) file.camera = header.camera;
    return file;
}

}  // namespace

ImportedFile import_mesh(const std::string& path, const std::string& name, const std::string& place, Scene<3>& scene,
                         const std::function<void(double share)>& progress) {
    check_ending(path, name, place);
    for (const OwnFormat& format : own_formats)
        if (ending_of(path) == format.ending) return import_own(format, path, name, place, scene, progress);
    if (is_gltf(path)) {
        progress(0.1);
        if (std::optional<ImportedFile> file = read_gltf(path, name, place, scene)) return *std::move(file);
    }
    return import_with_assimp(path, name, place, scene, progress);
}

bool is_mesh_ending(const std::string& ending) {
    return ending.size() > 1 && std::find(std::begin(no_mesh), std::end(no_mesh), ending) == std::end(no_mesh) &&
           Assimp::Importer().IsExtensionSupported(ending);
}

}  // namespace sightline
