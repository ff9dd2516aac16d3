// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_mesh.h"

#include <algorithm>
#include <filesystem>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/scene/clean.h"
#include "core/scene/read/file_kind.h"
#include "core/scene/read/file_objects.h"
#include "core/scene/read/import_mesh.h"
#include "core/scene/up_axis.h"

namespace sightline {

namespace {

namespace fs = std::filesystem;

struct MeshFile {
    std::string path;
    std::string place;  ///< for error lines
    bool named;         ///< by the caller; others were found in a folder
};

/// Endings that mean a 3D format to Assimp and mostly something else to people.
bool is_doubtful(const std::string& ending) { return ending == ".xml" || ending == ".raw"; }

std::vector<MeshFile> files_of(std::span<const std::string> paths, const std::string& name) {
    std::vector<MeshFile> files;
    for (const std::string& path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            files.push_back({path, paths.size() > 1 ? path : "", true});
            continue;
        }
        std::vector<std::string> found;
        try {
            for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path)) {
                const std::string ending = ending_of(entry.path().string());
                if (entry.is_regular_file() && is_mesh_ending(ending) && !is_doubtful(ending))
                    found.push_back(entry.path().string());
            }
        } catch (const fs::filesystem_error& failure) {
            throw input_error(name, failure.path1().string(), failure.code().message());
        }
        if (found.empty()) throw input_error(name, paths.size() > 1 ? path : "", "holds no file of a 3D format");
        std::sort(found.begin(), found.end());
        for (const std::string& file : found)
            files.push_back({file, paths.size() > 1 ? file : fs::path(file).lexically_relative(path).string(), false});
    }
    return files;
}

void check(const MeshFile& mesh, const std::string& name) {
    std::uint64_t size = 0;
    try {
        size = check_file(mesh.path);
    } catch (const InputError& error) {
        throw input_error(name, mesh.place, std::string(error.what()).substr(mesh.path.size() + 2));  // past "path: "
    }
    if (size == 0) throw input_error(name, mesh.place, "the file is empty");
}

/// What the file is called in the names of objects.
std::string label(const MeshFile& mesh) {
    return mesh.named || mesh.place.empty() ? fs::path(mesh.path).filename().string() : mesh.place;
}

}  // namespace

Scene<3> read_meshes(std::span<const std::string> paths, const std::string& name, const MeshOptions& options) {
    const std::vector<MeshFile> files = files_of(paths, name);
    Scene<3> scene;
    scene.id = scene.title = name;
    std::optional<ViewSpec<3>> camera;
    bool any = false, axes_differ = false, names_up = true;
    std::string first_failure;
    for (std::size_t k = 0; k < files.size(); ++k) {
        const MeshFile& mesh = files[k];
        const std::string what = "reading " + fs::path(mesh.path).filename().string();
        const std::size_t before = scene.primitives.size(), names_before = scene.objects.names.size();
        try {
            check(mesh, name);
            const ImportedFile file = import_mesh(mesh.path, name, mesh.place, scene,
                                                  [&](double share) { report(options.progress, what, share); });
            if (!any) {
                scene.source = file.format;
                scene.up_axis = file.up_axis;
            }
            names_up = names_up && file.names_up;
            name_file_objects(scene, names_before, files.size() > 1 ? label(mesh) : "");
            scene.paths.insert(scene.paths.end(), file.paths.begin(), file.paths.end());
            axes_differ = axes_differ || file.up_axis != scene.up_axis;
            if (!camera) camera = file.camera;
            any = true;
        } catch (const InputError& error) {
            if (mesh.named) throw;
            resize_primitives(scene, before);  // its reader may have ended in the middle
            const std::string failure = std::string(error.what()).substr(name.size() + 2);  // past "name: "
            if (first_failure.empty()) first_failure = failure;
            scene.warnings.push_back("left out: " + failure);
        }
    }
    if (!any) throw input_error(name, "", "none of its files can be read; the first error is " + first_failure);
    if (axes_differ && (options.up == Up::automatic || options.up == Up::format))
        scene.warnings.push_back("the files disagree on which axis points up; that of the first file is used");
    if (options.two_sided) scene.two_sided.assign(scene.primitives.size(), 1);
    scene.start_view = camera;  // which moves with the triangles
    clean(scene, Recentre::yes, name, options.progress);
    for (FlightPath<3>& path : scene.paths) path.origin = scene.origin;
    turn_up(scene, options.up, names_up);
    if (!options.choose_view) return scene;
    report(options.progress, "choosing a view", 0);
    scene.start_view = default_view(scene.primitives, scene.up_axis, scene.two_sided, scene.start_view);
    report(options.progress, "choosing a view", 1);
    return scene;
}

Scene<3> read_mesh(const std::string& path, const std::string& name, const MeshOptions& options) {
    return read_meshes({&path, 1}, name, options);
}

}  // namespace sightline
