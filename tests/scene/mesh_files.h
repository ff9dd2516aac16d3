// Small 3D files that the tests write themselves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/geometry/vec.h"
#include "core/scene/read/read_mesh.h"
#include "tests/scene/scene_support.h"

namespace sightline::test {

struct Mesh {
    std::vector<Vec<3>> points;
    std::vector<std::array<std::uint32_t, 3>> faces;
};

/// From (0, 0, 0) to (1, 1, 1), fronts outside.
inline Mesh cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) mesh.points.push_back(Vec<3>(i & 1, i >> 1 & 1, i >> 2 & 1));
    mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                  {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

/// Three decimals.
inline std::string words(const Vec<3>& p) {
    char text[120];
    std::snprintf(text, sizeof text, "%.3f %.3f %.3f", p.x, p.y, p.z);
    return text;
}
inline std::string words(const std::array<std::uint32_t, 3>& f, std::uint32_t first) {
    return std::to_string(f[0] + first) + " " + std::to_string(f[1] + first) + " " + std::to_string(f[2] + first);
}
inline std::string float_bytes(const Vec<3>& p) {
    std::string bytes;
    for (int i = 0; i < 3; ++i) {
        const auto value = static_cast<float>(p[i]);
        std::uint32_t bits;
        std::memcpy(&bits, &value, 4);
        bytes += little(bits, 4);
    }
    return bytes;
}

inline std::string obj_of(const Mesh& mesh) {
    std::string text = "# a mesh\no thing\n";
    for (const Vec<3>& p : mesh.points) text += "v " + words(p) + "\n";
    for (const auto& f : mesh.faces) text += "f " + words(f, 1) + "\n";
    return text;
}

inline std::string off_of(const Mesh& mesh) {
    std::string text = "OFF\n" + std::to_string(mesh.points.size()) + " " + std::to_string(mesh.faces.size()) + " 0\n";
    for (const Vec<3>& p : mesh.points) text += words(p) + "\n";
    for (const auto& f : mesh.faces) text += "3 " + words(f, 0) + "\n";
    return text;
}

inline std::string ply_of(const Mesh& mesh, bool binary) {
    std::string text = std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") +
                       " 1.0\ncomment a mesh\nelement vertex " + std::to_string(mesh.points.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec<3>& p : mesh.points) text += binary ? float_bytes(p) : words(p) + "\n";
    for (const auto& f : mesh.faces)
        text += binary ? "\3" + little(f[0], 4) + little(f[1], 4) + little(f[2], 4) : "3 " + words(f, 0) + "\n";
    return text;
}

inline std::string stl_of(const Mesh& mesh, bool binary) {
    std::string text =
        binary ? std::string(80, 'h') + little(static_cast<std::uint32_t>(mesh.faces.size()), 4) : "solid thing\n";
    for (const auto& f : mesh.faces) {
        text += binary ? float_bytes(Vec<3>(0, 0, 1)) : "facet normal 0 0 1\nouter loop\n";
        for (const std::uint32_t k : f)
            text += binary ? float_bytes(mesh.points[k]) : "vertex " + words(mesh.points[k]) + "\n";
        text += binary ? little(0, 2) : "endloop\nendfacet\n";
    }
    return binary ? text : text + "endsolid thing\n";
}

inline std::string base64(const std::string& bytes) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

/// The points and then the faces.
inline std::string gltf_buffer(const Mesh& mesh) {
    std::string buffer;
    for (const Vec<3>& p : mesh.points) buffer += float_bytes(p);
    for (const auto& f : mesh.faces)
        for (const std::uint32_t k : f) buffer += little(k, 4);
    return buffer;
}

/// Meshes 0 and 1 are the same but for the material: 1 is two-sided. Camera 0 is 45 degrees high, 1:2. The first node
/// of `nodes` and those that nobody has as a child are shown.
inline std::string gltf_of(const Mesh& mesh, const std::string& nodes = R"([{"mesh": 0}])") {
    const std::string buffer = gltf_buffer(mesh);
    const std::size_t indices = 12 * mesh.points.size();
    const auto text = [](std::size_t number) { return std::to_string(number); };
    const bool flat = nodes.find("children") == std::string::npos;
    std::size_t count = 0;  // of nodes, when none has children
    for (std::size_t at = 0; flat && (at = nodes.find('{', at)) != std::string::npos; ++at) ++count;
    std::string roots = "0";
    for (std::size_t i = 1; i < count; ++i) roots += "," + text(i);
    const auto mesh_with = [](int material) {
        return R"({"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": )" +
               std::to_string(material) + "}]}";
    };
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [)" + roots + R"(]}], "nodes": )" + nodes +
           R"(, "meshes": [)" + mesh_with(0) + "," + mesh_with(1) +
           R"(], "materials": [{"name": "one"}, {"name": "two", "doubleSided": true}],
           "cameras": [{"type": "perspective", "perspective": {"yfov": 0.785398163, "aspectRatio": 2, "znear": 0.1}}],
           "buffers": [{"byteLength": )" +
           text(buffer.size()) + R"(, "uri": "data:application/octet-stream;base64,)" + base64(buffer) +
           R"("}], "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": )" + text(indices) +
           R"(}, {"buffer": 0, "byteOffset": )" + text(indices) + R"(, "byteLength": )" +
           text(buffer.size() - indices) + R"(}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": )" +
           text(mesh.points.size()) +
           R"(, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]}, {"bufferView": 1, "componentType": 5125, "count": )" +
           text(mesh.faces.size() * 3) + R"(, "type": "SCALAR"}]})";
}

/// As gltf_of(), in the binary container.
inline std::string glb_of(const Mesh& mesh) {
    std::string json = gltf_of(mesh);
    const std::string uri = R"(, "uri": ")";
    const std::size_t from = json.find(uri);
    json.erase(from, json.find('"', from + uri.size()) + 1 - from);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::string buffer = gltf_buffer(mesh);
    const auto number = [](std::size_t n) { return little(static_cast<std::uint32_t>(n), 4); };
    return "glTF" + number(2) + number(28 + json.size() + buffer.size()) + number(json.size()) + "JSON" + json +
           number(buffer.size()) + std::string("BIN\0", 4) + buffer;
}

/// An empty folder that lives as long as the object.
class Folder {
public:
    explicit Folder(const std::string& name) : path_(std::filesystem::path(::testing::TempDir()) / name) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }
    void write(const std::string& name, const std::string& bytes) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << bytes;
    }
    std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

/// COLLADA, which Assimp reads.
inline std::string dae_of(const Mesh& mesh) {
    std::string points, corners;
    char number[40];
    for (const Vec<3>& p : mesh.points)
        for (int axis = 0; axis < 3; ++axis)
            points.append(number, std::snprintf(number, sizeof number, "%.2f ", p[axis]));
    for (const auto& f : mesh.faces) corners += words(f, 0) + " ";
    const std::string count = std::to_string(mesh.points.size());
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
        <asset><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p">
        <float_array id="a" count=")" +
           std::to_string(3 * mesh.points.size()) + "\">" + points +
           R"(</float_array><technique_common><accessor source="#a" count=")" + count + R"(" stride="3">
        <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
        </technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
        <triangles count=")" +
           std::to_string(mesh.faces.size()) + R"("><input semantic="VERTEX" source="#v" offset="0"/>
        <p>)" +
           corners + R"(</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>
        <visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
        <scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// The scene of a file with this name and content.
inline Scene<3> read_bytes(const std::string& name, const std::string& bytes) {
    const TemporaryFile file(name, bytes);
    return read_mesh(file.path(), "x");
}

/// The corners of the scene's triangles in the file's coordinates.
inline std::vector<Primitive<3>> in_file(const Scene<3>& scene) {
    std::vector<Primitive<3>> triangles = scene.primitives;
    for (Primitive<3>& triangle : triangles)
        for (Vec<3>& corner : triangle) corner += scene.origin;
    return triangles;
}

/// A pyramid on a square of 2 by 2, 3 high along y, fronts outside.
inline Mesh pyramid_mesh() {
    return {{Vec<3>(0), Vec<3>(2, 0, 0), Vec<3>(2, 0, 2), Vec<3>(0, 0, 2), Vec<3>(1, 3, 1)},
            {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}}};
}

inline std::vector<Primitive<3>> triangles_of(const Mesh& mesh) {
    std::vector<Primitive<3>> triangles;
    for (const auto& f : mesh.faces) triangles.push_back({mesh.points[f[0]], mesh.points[f[1]], mesh.points[f[2]]});
    return triangles;
}

}  // namespace sightline::test
