// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/assimp_reader.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cstring>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <span>
#include <string_view>

#include "core/base/trig.h"
#include "core/scene/read/file_kind.h"

namespace sightline {

namespace {

template <std::size_t N>
void copy(std::string_view text, char (&to)[N]) {
    std::memcpy(to, text.data(), std::min(text.size(), N - 1));
}

void refuse(AssimpHeader& header, std::string_view reason) {
    header.failed = 1;
    copy(reason, header.text);
}

/// Opens files only, whatever a model names: who opens a pipe waits for its other end. Assimp asks whether a file is
/// there by opening it.
class RegularFiles : public Assimp::DefaultIOSystem {
public:
    bool Exists(const char* path) const override {
        std::error_code no_error;
        return std::filesystem::is_regular_file(path, no_error);
    }
    Assimp::IOStream* Open(const char* path, const char* mode) override {
        return Exists(path) ? DefaultIOSystem::Open(path, mode) : nullptr;
    }
};

struct Instance {
    const aiMesh* mesh;
    glm::dmat4 to_scene;
    const aiNode* node;
};

glm::dmat4 matrix(const aiMatrix4x4& m) {
    glm::dmat4 out;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            out[static_cast<int>(column)][static_cast<int>(row)] = m[row][column];
    return out;
}

Vec<3> vector(const aiVector3D& v) { return {v.x, v.y, v.z}; }
Vec<3> transformed(const glm::dmat4& m, const Vec<3>& p) { return Vec<3>(m * glm::dvec4(p, 1)); }

/// Every use of a mesh, in the order of the nodes, and the first camera.
std::vector<Instance> instances_of(const aiScene& scene, std::string_view format, AssimpHeader& header) {
    std::vector<Instance> instances;
    struct Visit {
        const aiNode* node;
        glm::dmat4 to_scene;
    };
    std::vector<Visit> visits;
    if (scene.mRootNode) visits.push_back({scene.mRootNode, matrix(scene.mRootNode->mTransformation)});
    const aiCamera* camera = scene.mNumCameras > 0 ? scene.mCameras[0] : nullptr;
    while (!visits.empty()) {
        const Visit visit = visits.back();
        visits.pop_back();
        for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
            const unsigned mesh = visit.node->mMeshes[i];
            if (mesh < scene.mNumMeshes) instances.push_back({scene.mMeshes[mesh], visit.to_scene, visit.node});
        }
        if (camera && camera->mName == visit.node->mName && !header.has_camera) {
            header.has_camera = 1;
            // glTF cameras stand at their node's origin; Assimp gives the node's translation once more as position.
            const Vec<3> position = format == "gltf" ? Vec<3>(0) : vector(camera->mPosition);
            header.camera.eye = transformed(visit.to_scene, position);
            const Vec<3> ahead = glm::dmat3(visit.to_scene) * vector(camera->mLookAt);
            header.camera.look_at = header.camera.eye + ahead / std::sqrt(glm::dot(ahead, ahead));
            // Assimp's glTF reader multiplies the vertical angle by the aspect.
            const double aspect = camera->mAspect > 0 ? static_cast<double>(camera->mAspect) : 1;
            header.camera.fov =
                std::clamp(static_cast<double>(camera->mHorizontalFOV) / aspect * 180 / pi, 10.0, 120.0);
        }
        for (unsigned i = visit.node->mNumChildren; i-- > 0;)
            visits.push_back(
                {visit.node->mChildren[i], visit.to_scene * matrix(visit.node->mChildren[i]->mTransformation)});
    }
    return instances;
}

bool is_triangle(const aiFace& face) { return face.mNumIndices == 3; }

std::size_t triangles_in(const aiMesh& mesh) {
    const std::span<const aiFace> faces(mesh.mFaces, mesh.mNumFaces);
    return static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), is_triangle));
}

bool is_two_sided(const aiScene& scene, const aiMesh& mesh) {
    int two_sided = 0;
    if (mesh.mMaterialIndex < scene.mNumMaterials)
        scene.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_TWOSIDED, two_sided);
    return two_sided != 0;
}

/// Formats with a rule, which Assimp turns to y where it is another one.
bool has_up(std::string_view format) {
    for (const std::string_view rule :
         {"gltf", "dae",     "3mf", "amf", "x3d",    "wrl", "b3d", "blend", "3ds", "ase",    "md2",
          "md3",  "md5mesh", "mdl", "ifc", "assbin", "x",   "lwo", "lws",   "irr", "irrmesh"})
        if (format == rule) return true;
    return false;
}

int up_axis_of(const aiScene& scene, std::string_view format, AssimpHeader& header) {
    int axis = 0;
    header.names_up = has_up(format);
    if (scene.mMetaData && scene.mMetaData->Get("UpAxis", axis) && axis >= 0 && axis <= 2) {
        header.names_up = 1;
        return axis;
    }
    for (const std::string_view z : {"3mf", "amf", "raw"})
        if (format == z) return 2;
    return 1;
}

/// Counts the triangles and makes sure that they refer to vertices that exist.
void check_faces(const std::vector<Instance>& instances, AssimpHeader& header) {
    for (const Instance& instance : instances)
        for (unsigned f = 0; f < instance.mesh->mNumFaces; ++f) {
            const aiFace& face = instance.mesh->mFaces[f];
            if (!is_triangle(face)) continue;
            ++header.triangles;
            for (unsigned c = 0; c < 3; ++c)
                if (face.mIndices[c] >= instance.mesh->mNumVertices)
                    return refuse(header, "a face refers to vertex " + std::to_string(face.mIndices[c]) + " of " +
                                              std::to_string(instance.mesh->mNumVertices));
        }
}

void send_triangles(const std::vector<Instance>& instances, const ChildProcess::Send& send) {
    std::vector<Primitive<3>> batch;
    const auto flush = [&] {
        send(batch.data(), batch.size() * sizeof(Primitive<3>));
        batch.clear();
    };
    for (const Instance& instance : instances) {
        const bool mirrored = glm::determinant(glm::dmat3(instance.to_scene)) < 0;
        for (unsigned f = 0; f < instance.mesh->mNumFaces; ++f) {
            const aiFace& face = instance.mesh->mFaces[f];
            if (!is_triangle(face)) continue;
            Primitive<3>& triangle = batch.emplace_back();
            for (unsigned c = 0; c < 3; ++c)
                triangle[c] = transformed(instance.to_scene, vector(instance.mesh->mVertices[face.mIndices[c]]));
            if (mirrored) std::swap(triangle[1], triangle[2]);
            if (batch.size() == 4096) flush();
        }
    }
    flush();
}

void send_sides(const aiScene& scene, const std::vector<Instance>& instances, const ChildProcess::Send& send) {
    for (const Instance& instance : instances) {
        const std::vector<std::uint8_t> sides(triangles_in(*instance.mesh), is_two_sided(scene, *instance.mesh));
        send(sides.data(), sides.size());
    }
}

void send_objects(const std::vector<Instance>& instances, const ChildProcess::Send& send) {
    for (std::size_t i = 0; i < instances.size();) {
        AssimpObject object;
        const aiNode* const node = instances[i].node;
        const aiString& name = node->mName.length > 0 ? node->mName : instances[i].mesh->mName;
        copy({name.C_Str(), name.length}, object.name);
        for (; i < instances.size() && instances[i].node == node; ++i)
            object.triangles += triangles_in(*instances[i].mesh);
        send(&object, sizeof object);
    }
}

/// The first complaint about damage; Assimp calls harmless things errors, too.
class Complaints : public Assimp::LogStream {
public:
    explicit Complaints(AssimpHeader& header) : header_(header) {}
    void write(const char* message) override {
        std::string_view line(message);
        line.remove_prefix(std::min(line.find(": ") + 2, line.size()));  // "Error, T0: "
        for (const char* damage : {"out of range", "nvalid", "nexpected", "orrupt"})
            if (header_.warning[0] == 0 && line.find(damage) != std::string_view::npos)
                copy(line.substr(0, line.find('\n')), header_.warning);
    }

private:
    AssimpHeader& header_;
};

/// Of Assimp's "gltf glb" or "mesh mesh.xml".
bool lists(std::string_view endings, std::string_view ending) {
    for (; !endings.empty(); endings.remove_prefix(std::min(endings.find(' '), endings.size() - 1) + 1)) {
        const std::string_view one = endings.substr(0, endings.find(' '));
        if (one == ending.substr(1) || one.ends_with(ending)) return true;
    }
    return false;
}

}  // namespace

void read_with_assimp(const std::string& path, const ChildProcess::Send& send) {
    AssimpHeader header;
    Assimp::DefaultLogger::create(nullptr, Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(new Complaints(header), Assimp::Logger::Err);
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);  // bones are no scene
    importer.SetIOHandler(new RegularFiles);                              // which the importer then owns
    const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
    const aiScene nothing;
    const std::string error = importer.GetErrorString();
    const bool is_empty = error == "GLTF: No scene";
    if (!scene && is_empty) {
        scene = &nothing;
        header.warning[0] = 0;
    }
    if (!scene) {
        refuse(header, error);
        return send(&header, sizeof header);
    }
    const auto reader = static_cast<std::size_t>(importer.GetPropertyInteger("importerIndex", 0));
    const std::string_view endings = importer.GetImporterInfo(reader)->mFileExtensions;
    const std::string_view format = endings.substr(0, endings.find(' '));
    const std::string ending = ending_of(path);
    if (!lists(endings, ending)) {
        refuse(header, "its extension is " + ending + ", but its contents belong in ." + std::string(format));
        return send(&header, sizeof header);
    }
    copy(format, header.text);
    header.up_axis = static_cast<std::uint8_t>(up_axis_of(*scene, format, header));
    const std::vector<Instance> instances = instances_of(*scene, format, header);
    for (const Instance& instance : instances) header.any_two_sided |= is_two_sided(*scene, *instance.mesh);
    for (std::size_t i = 0; i < instances.size(); ++i)
        header.objects += i == 0 || instances[i].node != instances[i - 1].node;
    check_faces(instances, header);
    // What Assimp's readers of other formats make nothing of is more likely another kind of file.
    if (header.triangles == 0 && !header.failed && !is_empty && format != "gltf")
        refuse(header, "no triangle is found in it, read as ." + std::string(format));
    send(&header, sizeof header);
    if (header.failed) return;
    send_triangles(instances, send);
    if (header.any_two_sided) send_sides(*scene, instances, send);
    if (header.objects > 1) send_objects(instances, send);
}

}  // namespace sightline
