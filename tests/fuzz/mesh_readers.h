// As readers.h, for the readers of 3D files: what they give is cleaned as a scene is.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/clean.h"
#include "core/scene/read/read_obj.h"
#include "core/scene/read/read_off.h"
#include "core/scene/read/read_ply.h"
#include "core/scene/read/read_stl.h"
#include "tests/fuzz/readers.h"

namespace sightline::fuzz {

inline bool is_usable(const ParsedMesh& mesh) {
    for (const std::string& warning : mesh.warnings)
        if (!is_one_line("input: " + warning)) return false;
    if (mesh.triangles.capacity() > 2 * mesh.triangles.size() + 64) return false;  // memory for what is not there
    for (const std::uint32_t object : mesh.objects.of)
        if (object >= mesh.objects.names.size()) return false;
    if (!mesh.objects.empty() && mesh.objects.of.size() != mesh.triangles.size()) return false;
    Scene<3> scene;
    scene.primitives = mesh.triangles;
    scene.objects = mesh.objects;
    clean(scene, Recentre::yes, "input");
    return scene.primitives.size() + scene.dropped.total() == mesh.triangles.size();
}

/// As check().
inline int check_mesh(ParsedMesh (*read)(std::string_view, const ShareDone&), const std::uint8_t* data,
                      std::size_t size) {
    ParsedMesh mesh;
    try {
        mesh = read(bytes_of(data, size), {});
    } catch (const InputError& error) {
        if (!is_one_line(std::string("input: ") + error.what())) std::abort();
        return 0;
    }
    try {
        if (!is_usable(mesh)) std::abort();
    } catch (const InputError&) {  // too large, too small
    }
    return 1;
}

inline int fuzz_obj(const std::uint8_t* data, std::size_t size) { return check_mesh(read_obj, data, size); }
inline int fuzz_ply(const std::uint8_t* data, std::size_t size) { return check_mesh(read_ply, data, size); }
inline int fuzz_stl(const std::uint8_t* data, std::size_t size) { return check_mesh(read_stl, data, size); }
inline int fuzz_off(const std::uint8_t* data, std::size_t size) { return check_mesh(read_off, data, size); }

}  // namespace sightline::fuzz
