// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_gltf.h"

#include <algorithm>
#include <array>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/base/text.h"
#include "core/scene/read/gltf_document.h"
#include "core/scene/read/gltf_nodes.h"

namespace sightline {

namespace {

/// Of a primitive.
enum GltfMode : std::size_t { triangles = 4, strip = 5, fan = 6 };

struct GltfMorph {
    GltfNumbers shift;
    double weight;
};

/// A primitive of a mesh as it is used by a node.
struct GltfPart {
    GltfNumbers positions;
    std::optional<GltfNumbers> indices;
    std::vector<GltfMorph> morphs;
    std::optional<GltfNumbers> joints, weights;
    std::size_t mode = triangles;
    bool two_sided = false;

    std::size_t corners() const { return indices ? indices->count : positions.count; }
    std::size_t count() const { return mode == triangles ? corners() / 3 : corners() < 3 ? 0 : corners() - 2; }
    /// The places of a triangle's corners among the indices: of a strip every second one turns the other way.
    std::array<std::size_t, 3> triangle(std::size_t i) const {
        if (mode == triangles) return {3 * i, 3 * i + 1, 3 * i + 2};
        if (mode == fan) return {i + 1, i + 2, 0};
        return {i, i + 1 + i % 2, i + 2 - i % 2};
    }
};

class GltfReader {
public:
    GltfReader(GltfDocument& file, Scene<3>& scene) : file_(file), scene_(scene), nodes_(gltf_nodes(file)) {}

    void read() {
        struct Instance {
            std::uint32_t node;
            std::vector<GltfPart> parts;
        };
        std::vector<Instance> instances;
        std::size_t count = 0;
        for (const std::uint32_t node : nodes_.shown) {
            Instance instance{node, parts_of(node)};
            for (const GltfPart& part : instance.parts) count += part.count();
            if (!instance.parts.empty()) instances.push_back(std::move(instance));
        }
        // As for other readers: 2 GB and 50 bytes for each of the file.
        if (static_cast<double>(count) * sizeof(Primitive<3>) > 2e9 + 50 * static_cast<double>(file_.bytes()))
            file_.fail("", "needs far more memory than its size suggests: it announces " + std::to_string(count) +
                               " triangles");
        scene_.primitives.reserve(scene_.primitives.size() + count);
        first_ = scene_.primitives.size();
        scene_.objects.of.resize(first_);
        for (const Instance& instance : instances) add(instance.node, instance.parts);
        if (any_two_sided_ || !scene_.two_sided.empty()) {
            scene_.two_sided.resize(first_);
            scene_.two_sided.insert(scene_.two_sided.end(), sides_.begin(), sides_.end());
        }
        words();
    }

    ImportedFile facts() {
        Box<3> box;
        for (std::size_t i = first_; i < scene_.primitives.size(); ++i)
            for (const Vec<3>& v : scene_.primitives[i]) box.add(v);
        const bool any = first_ < scene_.primitives.size() && box.longest_side() > 0;
        GltfCameras cameras = gltf_cameras(file_, nodes_, any ? box.longest_side() / 4 : 1);
        warnings_.insert(warnings_.end(), cameras.warnings.begin(), cameras.warnings.end());
        ImportedFile facts{"gltf", 1, cameras.first};
        facts.paths = std::move(cameras.paths);
        return facts;
    }
    const std::vector<std::string>& warnings() const { return warnings_; }

private:
    std::vector<GltfPart> parts_of(std::uint32_t node_index) {
        std::vector<GltfPart> parts;
        const std::string node_at = "/nodes/" + std::to_string(node_index);
        const Json& node = file_.element("nodes", node_index, node_at);
        const auto mesh_index = file_.whole(node, "mesh", node_at);
        if (!mesh_index) return parts;
        if (const auto extensions = node.find("extensions");
            extensions != node.end() && extensions->is_object() && extensions->contains("EXT_mesh_gpu_instancing"))
            ++instanced_;
        const std::string mesh_at = "/meshes/" + std::to_string(*mesh_index);
        const Json& mesh = file_.element("meshes", *mesh_index, node_at);
        const auto list = mesh.find("primitives");
        if (list == mesh.end() || !list->is_array()) file_.fail(mesh_at, "\"primitives\" is missing");
        for (std::size_t k = 0; k < list->size(); ++k) {
            const std::string at = mesh_at + "/primitives/" + std::to_string(k);
            const Json& primitive = (*list)[k];
            if (!primitive.is_object()) file_.fail(at, "expected an object");
            const std::size_t mode = file_.whole(primitive, "mode", at).value_or(triangles);
            if (mode > fan) file_.fail(at, "mode " + std::to_string(mode) + " is none of glTF");
            if (mode < triangles) {
                ++no_triangles_;
                continue;
            }
            const auto attributes = primitive.find("attributes");
            const auto position = attributes == primitive.end() || !attributes->is_object()
                                      ? std::nullopt
                                      : file_.whole(*attributes, "POSITION", at);
            if (!position) {
                ++no_positions_;
                continue;
            }
            GltfPart part;
            part.mode = mode;
            part.positions = vectors(*position, 3, at);
            if (const auto indices = file_.whole(primitive, "indices", at)) {
                part.indices = file_.numbers(*indices);
                if (part.indices->components != 1 || !part.indices->whole)
                    file_.fail(at, "its indices are no whole numbers");
            }
            if (mode == triangles && part.corners() % 3 != 0) ++cut_short_;
            part.two_sided = is_two_sided(primitive, at);
            add_morphs(part, primitive, node, mesh, at);
            if (node.contains("skin") && attributes->contains("JOINTS_0") && attributes->contains("WEIGHTS_0")) {
                part.joints = vectors(file_.required(*attributes, "JOINTS_0", at), 4, at);
                part.weights = vectors(file_.required(*attributes, "WEIGHTS_0", at), 4, at);
                if (part.joints->count < part.positions.count || part.weights->count < part.positions.count)
                    file_.fail(at, "has fewer joints or weights than vertices");
            }
            parts.push_back(std::move(part));
        }
        return parts;
    }

    GltfNumbers vectors(std::size_t accessor, int components, const std::string& at) {
        GltfNumbers numbers = file_.numbers(accessor);
        if (numbers.components != components)
            file_.fail(at, "/accessors/" + std::to_string(accessor) + " has " + std::to_string(numbers.components) +
                               " numbers an element, " + std::to_string(components) + " expected");
        return numbers;
    }

    bool is_two_sided(const Json& primitive, const std::string& at) const {
        const auto material = file_.whole(primitive, "material", at);
        if (!material || *material >= file_.list("materials").size()) return false;
        const Json& of = file_.list("materials")[*material];
        return of.is_object() && of.contains("doubleSided") && of["doubleSided"] == true;
    }

    /// Weights are the node's, else the mesh's.
    void add_morphs(GltfPart& part, const Json& primitive, const Json& node, const Json& mesh, const std::string& at) {
        const auto targets = primitive.find("targets");
        if (targets == primitive.end() || !targets->is_array()) return;
        const Json& of = node.contains("weights") ? node : mesh;
        const auto weights =
            of.contains("weights") ? file_.finite(of, "weights", of["weights"].size(), at) : std::nullopt;
        for (std::size_t k = 0; weights && k < std::min(targets->size(), weights->size()); ++k) {
            if ((*weights)[k] == 0 || !(*targets)[k].is_object()) continue;
            const auto shift = file_.whole((*targets)[k], "POSITION", at);
            if (!shift) continue;
            part.morphs.push_back({vectors(*shift, 3, at), (*weights)[k]});
            if (part.morphs.back().shift.count < part.positions.count)
                file_.fail(at, "a morph target has fewer vertices than the mesh");
        }
    }

    /// From the skin's joints to the scene, each after what takes the mesh to the joint.
    std::vector<glm::dmat4> joints_of(const Json& node, const std::string& at) {
        std::vector<glm::dmat4> joints;
        const auto index = file_.whole(node, "skin", at);
        if (!index) return joints;
        const Json& skin = file_.element("skins", *index, at);
        std::optional<GltfNumbers> inverse;
        if (const auto accessor = file_.whole(skin, "inverseBindMatrices", at)) inverse = vectors(*accessor, 16, at);
        for (const std::size_t joint : file_.indices(skin, "joints", at)) {
            file_.element("nodes", joint, at);
            glm::dmat4 to_joint(1);
            if (inverse && joints.size() < inverse->count)
                for (int i = 0; i < 16; ++i) to_joint[i / 4][i % 4] = inverse->at(joints.size(), i);
            joints.push_back(nodes_.to_scene[joint] * to_joint);
        }
        return joints;
    }

    Vec<3> vertex(const GltfPart& part, std::size_t i, const glm::dmat4& to_scene,
                  const std::vector<glm::dmat4>& joints) const {
        Vec<3> p = part.positions.vector(i);
        for (const GltfMorph& morph : part.morphs) p += morph.weight * morph.shift.vector(i);
        if (!part.joints) return Vec<3>(to_scene * glm::dvec4(p, 1));
        glm::dvec4 sum(0);
        double weights = 0;
        for (int c = 0; c < 4; ++c) {
            const double weight = part.weights->at(i, c), joint = part.joints->at(i, c);
            if (!(weight > 0) || !(joint < static_cast<double>(joints.size()))) continue;
            sum += weight * (joints[static_cast<std::size_t>(joint)] * glm::dvec4(p, 1));
            weights += weight;
        }
        return weights > 0 ? Vec<3>(sum / weights) : Vec<3>(to_scene * glm::dvec4(p, 1));
    }

    void add(std::uint32_t node_index, const std::vector<GltfPart>& parts) {
        const std::string at = "/nodes/" + std::to_string(node_index);
        const Json& node = file_.element("nodes", node_index, at);
        std::string name = file_.text(node, "name");
        if (name.empty()) name = file_.text(file_.list("meshes")[file_.required(node, "mesh", at)], "name");
        if (name.empty()) name = "node " + std::to_string(node_index);
        const auto object = static_cast<std::uint32_t>(scene_.objects.names.size());
        scene_.objects.names.push_back(name);
        const glm::dmat4& to_scene = nodes_.to_scene[node_index];
        const std::vector<glm::dmat4> joints = joints_of(node, at);
        const bool mirrored = glm::determinant(glm::dmat3(to_scene)) < 0;
        for (const GltfPart& part : parts) {
            for (std::size_t i = 0; i < part.count(); ++i) {
                Primitive<3> triangle;
                bool there = true;
                const std::array<std::size_t, 3> places = part.triangle(i);
                for (std::size_t c = 0; c < 3 && there; ++c) {
                    const std::size_t index =
                        part.indices ? static_cast<std::size_t>(part.indices->at(places[c], 0)) : places[c];
                    there = index < part.positions.count;
                    if (there)
                        triangle[c] = vertex(part, index, to_scene, joints);
                    else if (outside_++ == 0)
                        example_ = "vertex " + std::to_string(index) + " of " + std::to_string(part.positions.count);
                }
                if (!there) continue;
                if (mirrored && !part.joints) std::swap(triangle[1], triangle[2]);
                scene_.primitives.push_back(triangle);
                scene_.objects.of.push_back(object);
                sides_.push_back(part.two_sided);
                any_two_sided_ |= part.two_sided;
            }
        }
    }

    void words() {
        const auto warn = [&](std::size_t count, const std::string& text) {
            if (count > 0) warnings_.push_back(text);
        };
        warn(outside_, counted(outside_, "triangle") + " left out: the indices do not exist (" + example_ + ")");
        warn(cut_short_,
             "the indices of " + counted(cut_short_, "primitive") + " are no multiple of 3: the rest is left out");
        warn(no_triangles_, counted(no_triangles_, "primitive") + " of points or lines left out");
        warn(no_positions_, counted(no_positions_, "primitive") + " without positions left out");
        warn(instanced_,
             "EXT_mesh_gpu_instancing is not supported: the mesh of " + counted(instanced_, "node") + " is shown once");
        if (nodes_.scenes > 0)
            warn(nodes_.unplaced, counted(nodes_.unplaced, "node") + " with a mesh left out: no scene has them");
        if (nodes_.scenes > 1) warnings_.push_back(counted(nodes_.scenes - 1, "other scene") + " of the file left out");
        if (nodes_.scenes == 0 && !file_.list("meshes").empty())
            warnings_.push_back("the file names no scene, so nothing of its " +
                                counted(file_.list("meshes").size(), "mesh") + " is shown");
    }

    GltfDocument& file_;
    Scene<3>& scene_;
    GltfNodes nodes_;
    std::size_t first_ = 0;
    std::vector<std::uint8_t> sides_;
    bool any_two_sided_ = false;
    std::size_t outside_ = 0, cut_short_ = 0, no_triangles_ = 0, no_positions_ = 0, instanced_ = 0;
    std::string example_;
    std::vector<std::string> warnings_;
};

}  // namespace

std::optional<ImportedFile> read_gltf(const std::string& path, const std::string& name, const std::string& place,
                                      Scene<3>& scene) {
    GltfDocument file(path, name, place);
    if (!file.is_version_2()) return std::nullopt;
    GltfReader reader(file, scene);
    reader.read();
    ImportedFile facts = reader.facts();
    for (const std::string& warning : reader.warnings())
        scene.warnings.push_back((place.empty() ? "" : place + ": ") + warning);
    return facts;
}

}  // namespace sightline
