// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/solid.h"

#include <algorithm>
#include <numeric>

#include "shell/gl/camera_matrix.h"

namespace sightline {

namespace {

class Flattener {
public:
    Flattener(const SolidList& list, Solid& to) : list_(list), to_(to) {}

    void add(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, std::uint8_t style) {
        if (cut_off(a) && cut_off(b) && cut_off(c)) return;
        for (const Vec<3>& p : {a, b, c}) to_.triangles.push_back(corner(p, list_.styles[style]));
    }
    void add_edge(const Vec<3>& a, const Vec<3>& b, std::uint8_t style) {
        for (const Vec<3>& p : {a, b}) to_.edges.push_back(corner(p, list_.styles[style]));
    }
    void add_face(std::size_t face) {
        const std::uint32_t begin = list_.face_begin[face], end = list_.face_begin[face + 1];
        for (std::uint32_t k = begin + 2; k < end; ++k)
            add(list_.points[begin], list_.points[k - 1], list_.points[k], list_.face_style[face]);
    }
    bool seen_through(std::size_t face) const { return list_.styles[list_.face_style[face]].colour.a < 255; }
    double distance(std::size_t face) const {
        Vec<3> sum(0);
        for (std::uint32_t k = list_.face_begin[face]; k < list_.face_begin[face + 1]; ++k) sum += list_.points[k];
        const Vec<3> d = sum / double(list_.face_begin[face + 1] - list_.face_begin[face]) - list_.camera.eye;
        return glm::dot(d, d);
    }

private:
    bool cut_off(const Vec<3>& p) const {
        return list_.slice && glm::dot(list_.slice->normal, p) > list_.slice->offset;
    }
    SolidCorner corner(const Vec<3>& p, const SolidStyle& style) const {
        const Vec<3> d = p - list_.camera.eye;
        return {static_cast<float>(d.x),
                static_cast<float>(d.y),
                static_cast<float>(d.z),
                {style.colour.r, style.colour.g, style.colour.b, style.colour.a},
                style.lit ? 1.0f : 0.0f};
    }

    const SolidList& list_;
    Solid& to_;
};

}  // namespace

Solid make_flat(const SolidList& list) {
    Solid solid;
    Flattener flat(list, solid);
    if (list.scene)
        for (const SolidList::Run& run : list.runs)
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
                const Primitive<3>& t = list.scene->primitives[list.triangles[i]];
                flat.add(t[0], t[1], t[2], run.style);
            }
    const std::size_t faces = list.face_style.size();
    std::vector<std::pair<double, std::size_t>> behind;
    for (std::size_t face = 0; face < faces; ++face)
        if (flat.seen_through(face))
            behind.emplace_back(-flat.distance(face), face);
        else
            flat.add_face(face);
    solid.opaque = static_cast<std::uint32_t>(solid.triangles.size());
    std::sort(behind.begin(), behind.end());
    for (const auto& [distance, face] : behind) flat.add_face(face);
    for (std::size_t i = 0; i < list.edge_style.size(); ++i)
        flat.add_edge(list.edge_points[2 * i], list.edge_points[2 * i + 1], list.edge_style[i]);

    Box<3> box;
    if (list.scene) box = bounds<3>(list.scene->primitives);
    for (const Vec<3>& p : list.points) box.add(p);
    if (box.empty()) box.add(list.camera.look_at);
    const CameraMatrix camera = camera_matrix(list.camera, box, false);
    for (std::size_t i = 0; i < 16; ++i) solid.clip[i] = camera.clip[static_cast<int>(i / 4)][static_cast<int>(i % 4)];
    const Vec<3> forward = list.camera.forward();
    const int up = list.scene ? list.scene->up_axis : 2;
    Vec<3> lamp(0.4, 0.4, 0.4);
    lamp[up] = 1;
    lamp[other_axis(up)] = -0.25;
    lamp /= std::sqrt(glm::dot(lamp, lamp));
    for (int i = 0; i < 3; ++i) {
        solid.forward[static_cast<std::size_t>(i)] = static_cast<float>(forward[i]);
        solid.lamp[static_cast<std::size_t>(i)] = static_cast<float>(lamp[i]);
    }
    solid.background = list.background;
    return solid;
}

}  // namespace sightline
