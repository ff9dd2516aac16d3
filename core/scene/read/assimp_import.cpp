// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <assimp/Importer.hpp>
#include <chrono>
#include <filesystem>
#include <sstream>
#include <string_view>

#include "core/base/text.h"
#include "core/scene/read/assimp_reader.h"
#include "core/scene/read/file_kind.h"
#include "core/scene/read/other_formats.h"

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

/// Of formats of Assimp that hold movement and no triangles; their readers take any text, or make up bones.
constexpr std::string_view no_mesh[] = {".bvh", ".csm", ".md5anim", ".md5camera", ".mot", ".vta"};

}  // namespace

ImportedFile import_other(const std::string& path, const std::string& name, const std::string& place, Scene<3>& scene,
                          const std::function<void(double share)>& progress) {
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

bool is_other_ending(const std::string& ending) {
    return ending.size() > 1 && std::find(std::begin(no_mesh), std::end(no_mesh), ending) == std::end(no_mesh) &&
           Assimp::Importer().IsExtensionSupported(ending);
}

std::set<std::string> other_endings() {
    std::string globs;
    Assimp::Importer().GetExtensionList(globs);  // "*.3d;*.3ds"
    std::set<std::string> endings;
    std::istringstream words(globs);
    for (std::string glob; std::getline(words, glob, ';');)
        if (is_other_ending(glob.substr(1))) endings.insert(glob.substr(1));
    return endings;
}

}  // namespace sightline
