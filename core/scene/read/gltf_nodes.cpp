// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <utility>

#include "core/base/index.h"
#include "core/scene/read/gltf_document.h"

namespace sightline {

glm::dmat4 GltfPlace::matrix() const {
    if (fixed) return *fixed;
    const double length = glm::dot(rotation, rotation);
    const double twice = length > 0 ? 2 / length : 0;  // files round quaternions to floats
    const double x = rotation.x, y = rotation.y, z = rotation.z, w = rotation.w;
    glm::dmat4 m(1);
    m[0] = glm::dvec4(1 - twice * (y * y + z * z), twice * (x * y + z * w), twice * (x * z - y * w), 0) * scale.x;
    m[1] = glm::dvec4(twice * (x * y - z * w), 1 - twice * (x * x + z * z), twice * (y * z + x * w), 0) * scale.y;
    m[2] = glm::dvec4(twice * (x * z + y * w), twice * (y * z - x * w), 1 - twice * (x * x + y * y), 0) * scale.z;
    m[3] = glm::dvec4(translation, 1);
    return m;
}

namespace {

GltfPlace place_of(const GltfDocument& file, const Json& node, const std::string& at) {
    GltfPlace place;
    if (const auto m = file.finite(node, "matrix", 16, at)) {
        place.fixed.emplace();
        for (int i = 0; i < 16; ++i) (*place.fixed)[i / 4][i % 4] = (*m)[static_cast<std::size_t>(i)];
    }
    if (const auto t = file.finite(node, "translation", 3, at)) place.translation = {(*t)[0], (*t)[1], (*t)[2]};
    if (const auto r = file.finite(node, "rotation", 4, at)) place.rotation = {(*r)[0], (*r)[1], (*r)[2], (*r)[3]};
    if (const auto s = file.finite(node, "scale", 3, at)) place.scale = {(*s)[0], (*s)[1], (*s)[2]};
    return place;
}

/// KHR_node_visibility: such a node and all below it are not shown.
bool is_hidden(const Json& node) {
    const auto extensions = node.find("extensions");
    if (extensions == node.end() || !extensions->is_object()) return false;
    const auto visibility = extensions->find("KHR_node_visibility");
    return visibility != extensions->end() && visibility->is_object() && visibility->contains("visible") &&
           (*visibility)["visible"] == false;
}

}  // namespace

GltfNodes gltf_nodes(const GltfDocument& file) {
    const Json& list = file.list("nodes");
    GltfNodes nodes;
    const std::size_t count = list.size();
    nodes.parents.assign(count, none);
    nodes.to_scene.assign(count, glm::dmat4(1));
    std::vector<std::vector<std::size_t>> children(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string at = "/nodes/" + std::to_string(i);
        const Json& node = file.element("nodes", i, at);
        nodes.places.push_back(place_of(file, node, at));
        children[i] = file.indices(node, "children", at);
        for (const std::size_t child : children[i]) {
            file.element("nodes", child, at);
            if (nodes.parents[child] != none) file.fail(at, "node " + std::to_string(child) + " has two parents");
            nodes.parents[child] = static_cast<std::uint32_t>(i);
        }
    }
    std::vector<std::size_t> visits;
    std::size_t reached = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (nodes.parents[i] == none) visits.push_back(i);
    for (; !visits.empty(); ++reached) {
        const std::size_t i = visits.back();
        visits.pop_back();
        const std::uint32_t parent = nodes.parents[i];
        nodes.to_scene[i] =
            parent == none ? nodes.places[i].matrix() : nodes.to_scene[parent] * nodes.places[i].matrix();
        visits.insert(visits.end(), children[i].begin(), children[i].end());
    }
    if (reached < count) file.fail("/nodes", "some nodes are their own ancestors");

    const Json& scenes = file.list("scenes");
    nodes.scenes = scenes.size();
    if (scenes.empty()) return nodes;
    const std::size_t scene = file.whole(file.root(), "scene", "").value_or(0);
    const std::string at = "/scenes/" + std::to_string(scene);
    visits = file.indices(file.element("scenes", scene, "/scene"), "nodes", at);
    std::reverse(visits.begin(), visits.end());
    std::vector<std::uint8_t> seen(count, 0);
    while (!visits.empty()) {
        const std::size_t i = visits.back();
        visits.pop_back();
        if (is_hidden(file.element("nodes", i, at)) || seen[i]) continue;
        seen[i] = 1;
        nodes.shown.push_back(static_cast<std::uint32_t>(i));
        visits.insert(visits.end(), children[i].rbegin(), children[i].rend());
    }
    std::vector<std::uint8_t> placed(count, 0);  // hidden ones too, and those of other scenes
    for (std::size_t k = 0; k < nodes.scenes; ++k) {
        const auto roots = file.indices(file.element("scenes", k, at), "nodes", "/scenes/" + std::to_string(k));
        visits.insert(visits.end(), roots.begin(), roots.end());
    }
    while (!visits.empty()) {
        const std::size_t i = visits.back();
        visits.pop_back();
        if (std::exchange(placed[i], 1) == 0) visits.insert(visits.end(), children[i].begin(), children[i].end());
    }
    for (std::size_t i = 0; i < count; ++i) nodes.unplaced += !placed[i] && file.list("nodes")[i].contains("mesh");
    return nodes;
}

glm::dvec4 between(const glm::dvec4& from, const glm::dvec4& to, double share) {
    glm::dvec4 a = from / std::sqrt(glm::dot(from, from)), b = to / std::sqrt(glm::dot(to, to));
    if (glm::dot(a, b) < 0) b = -b;  // the same turn, the short way round
    double low = 0, high = 1;
    // An arc of 2^-26 of half a turn differs from its chord by less than doubles show.
    for (int i = 0; i < 26; ++i) {
        const glm::dvec4 sum = a + b;
        const double middle = (low + high) / 2, length = std::sqrt(glm::dot(sum, sum));
        if (!(length > 0)) break;
        (share < middle ? b : a) = sum / length;
        (share < middle ? high : low) = middle;
    }
    const glm::dvec4 mixed = a + (b - a) * ((share - low) / (high - low));
    return mixed / std::sqrt(glm::dot(mixed, mixed));
}

}  // namespace sightline
