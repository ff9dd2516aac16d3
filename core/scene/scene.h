// A scene: a soup of primitives and where to look at it from.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/geometry/vec.h"
#include "core/scene/flight_path.h"
#include "core/scene/objects.h"
#include "core/scene/rooms.h"

namespace sightline {

/// A line segment in 2D, a triangle in 3D: D points. No structure between primitives is assumed.
template <int D>
using Primitive = std::array<Vec<D>, D>;

/// What a reader left out, each kind counted once per primitive.
struct Dropped {
    std::size_t degenerate = 0;  ///< zero length (2D) or zero area (3D)
    std::size_t duplicate =
        0;  ///< the same points as an earlier primitive: in either direction (2D), turning alike (3D)
    std::size_t not_finite = 0;  ///< a coordinate is NaN or infinite
    std::size_t total() const { return degenerate + duplicate + not_finite; }
    bool operator==(const Dropped&) const = default;
};

template <int D>
struct Scene {
    std::string id;      ///< catalogue id, or the file's name
    std::string title;   ///< a few words for people
    std::string lesson;  ///< one sentence: what it teaches; may be empty
    std::string source;  ///< "generated", or the reader's format
    std::string name;    ///< what load_scene took for it; empty when it came another way
    std::uint64_t seed = 0;
    std::vector<Primitive<D>> primitives;
    /// 3D, per primitive: 1 for one that is seen from both sides; empty: none is. Others are seen from the side on
    /// which their corners turn counter-clockwise.
    std::vector<std::uint8_t> two_sided;
    Objects objects;      ///< that the file names; empty: none, see connected_parts()
    Rooms<D> rooms;       ///< that the scene marks; empty: it is all outside
    int up_axis = D - 1;  ///< 3D: the axis that points up
    Vec<D> origin{};      ///< added to a coordinate gives that of the file
    std::optional<ViewSpec<D>> start_view;
    std::vector<FlightPath<D>> paths;  ///< 3D: those that come with the scene
    Dropped dropped;
    std::vector<std::string> warnings;  ///< one line each: what was ignored or looks odd; the scene is usable
};

template <int D>
bool shows_both_sides(const Scene<D>& scene, std::size_t primitive) {
    return !scene.two_sided.empty() && scene.two_sided[primitive];
}

/// Gives primitive `to` of a scene what is known of primitive `from` of another, or of the same; both know the same
/// kinds of things.
template <int D>
void copy_facts(const Scene<D>& of, std::size_t from, Scene<D>& scene, std::size_t to) {
    if (!of.two_sided.empty()) scene.two_sided[to] = of.two_sided[from];
    if (!of.objects.empty()) scene.objects.of[to] = of.objects.of[from];
}

/// Changes the number of primitives, and with it of what is known of each.
template <int D>
void resize_primitives(Scene<D>& scene, std::size_t count) {
    scene.primitives.resize(count);
    if (!scene.two_sided.empty()) scene.two_sided.resize(count);
    if (!scene.objects.empty()) scene.objects.of.resize(count);
}

template <int D>
Box<D> bounds(const std::vector<Primitive<D>>& primitives) {
    Box<D> box;
    for (const Primitive<D>& p : primitives)
        for (const Vec<D>& v : p) box.add(v);
    return box;
}

/// Those that the scene names, else the parts that hang together.
template <int D>
Objects all_objects(const Scene<D>& scene) {
    return scene.objects.empty() ? connected_parts<D>(scene.primitives) : scene.objects;
}

/// Identity of the geometry: the primitives in order and the origin, bit for bit.
template <int D>
std::uint64_t scene_hash(const Scene<D>& scene) {
    Hash hash;
    hash.add(scene.primitives.size());
    for (const Primitive<D>& p : scene.primitives)
        for (const Vec<D>& v : p)
            for (int i = 0; i < D; ++i) hash.add(v[i]);
    for (int i = 0; i < D; ++i) hash.add(scene.origin[i]);
    return hash.value();
}

}  // namespace sightline
