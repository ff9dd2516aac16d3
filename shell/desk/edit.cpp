// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/edit.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/index.h"
#include "core/scene/clean.h"
#include "core/scene/plan_rooms.h"
#include "core/scene/read/read_json.h"
#include "shell/desk/change.h"
#include "shell/desk/undo.h"

namespace sightline {

namespace {

/// A copy to edit.
Scene<2> edited(const Scene<2>& of) {
    Scene<2> scene = of;
    scene.source = "edited";
    scene.name.clear();  // what lies under that name is another scene now
    return scene;
}

Scene<2> edited(const Workbench<2>& bench) { return edited(bench.session.scene()); }

/// How far along the segment the point nearest to `at` lies: 0 at its start, 1 at its end.
double share_along(const Primitive<2>& segment, const Vec<2>& at) {
    const Vec<2> d = segment[1] - segment[0];
    return std::clamp(glm::dot(at - segment[0], d) / glm::dot(d, d), 0.0, 1.0);
}

/// Throws InputError unless the segment of that number is one that a reader of files would keep.
void check(const Scene<2>& scene, std::uint32_t index) {
    const Primitive<2> segment = scene.primitives[index];
    Scene<2> alone;
    alone.primitives = {segment};
    clean(alone, Recentre::no, "segment");
    if (alone.dropped.not_finite > 0) throw InputError("segment: a coordinate is not finite");
    if (alone.dropped.degenerate > 0) throw InputError("segment: both ends are the same point");
    for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
        const Primitive<2>& other = scene.primitives[i];
        if (i != index && (other == segment || other == Primitive<2>{segment[1], segment[0]}))
            throw InputError("segment: " + std::to_string(i) + " already joins these points");
    }
}

void put(Workbench<2>& bench, Scene<2> scene, const std::string& gesture, std::span<const std::uint32_t> numbers = {}) {
    if (!scene.rooms.empty()) scene.rooms = rooms_after_edit(bench.session.scene(), scene);
    change_scene(bench, std::make_shared<const Scene<2>>(std::move(scene)), gesture, numbers);
}

/// The object that segments drawn by hand belong to, where the scene has objects.
constexpr std::string_view drawn = "drawn";

}  // namespace

void add_segment(Workbench<2>& bench, const Primitive<2>& segment, const std::string& gesture) {
    Scene<2> scene = edited(bench);
    const auto added = static_cast<std::uint32_t>(scene.primitives.size());
    resize_primitives(scene, added + std::size_t{1});
    scene.primitives[added] = segment;
    if (!scene.objects.empty()) {
        if (object_named(scene.objects, drawn) == none) scene.objects.names.emplace_back(drawn);
        scene.objects.of[added] = object_named(scene.objects, drawn);
    }
    check(scene, added);
    put(bench, std::move(scene), gesture);
    bench.session.selected_cell = none;
    bench.session.selected_primitive = added;
}

void move_segment(Workbench<2>& bench, std::uint32_t index, const Primitive<2>& segment, const std::string& gesture) {
    Scene<2> scene = edited(bench);
    scene.primitives.at(index) = segment;
    check(scene, index);
    put(bench, std::move(scene), gesture);
}

void delete_segment(Workbench<2>& bench, std::uint32_t index) {
    Scene<2> scene = edited(bench);
    std::vector<std::uint32_t> numbers(scene.primitives.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    for (std::size_t i = index + 1; i < numbers.size(); ++i) --numbers[i];
    numbers.at(index) = none;
    for (std::size_t i = index + std::size_t{1}; i < scene.primitives.size(); ++i) {
        scene.primitives[i - 1] = scene.primitives[i];
        copy_facts(scene, i, scene, i - 1);
    }
    resize_primitives(scene, scene.primitives.size() - 1);
    tidy(scene.objects);
    put(bench, std::move(scene), "", numbers);
}

Vec<2> nearest_on(const Primitive<2>& segment, const Vec<2>& at) {
    const double t = share_along(segment, at);
    return t == 0 ? segment[0] : t == 1 ? segment[1] : segment[0] + (segment[1] - segment[0]) * t;
}

void cut_gap(Workbench<2>& bench, const std::shared_ptr<const Scene<2>>& before, std::uint32_t index,
             const Vec<2>& from, const Vec<2>& to, const std::string& gesture) {
    const Primitive<2> whole = before->primitives.at(index);
    Vec<2> first = nearest_on(whole, from), second = nearest_on(whole, to);
    if (share_along(whole, from) > share_along(whole, to)) std::swap(first, second);
    if (first == second) throw InputError("segment: a gap needs two different points of one segment");
    std::vector<Primitive<2>> left;
    if (whole[0] != first) left.push_back({whole[0], first});
    if (second != whole[1]) left.push_back({second, whole[1]});
    if (left.empty()) throw InputError("segment: nothing would be left; delete removes all of it");
    Scene<2> scene = edited(*before);
    scene.primitives[index] = left[0];
    check(scene, index);
    if (left.size() == 2) {
        resize_primitives(scene, scene.primitives.size() + 1);
        scene.primitives.back() = left[1];
        copy_facts(scene, index, scene, scene.primitives.size() - 1);
        check(scene, static_cast<std::uint32_t>(scene.primitives.size() - 1));
    }
    put(bench, std::move(scene), gesture);
    bench.session.selected_primitive = index;
}

void new_scene(Workbench<2>& bench) {
    Scene<2> scene;
    scene.id = "new";
    scene.title = "New scene";
    scene.source = "edited";
    const ViewSpec<2> view = default_view({});
    // One entry in the history for all of it.
    const std::string gesture = "new scene";
    remember(bench, gesture);
    bench.session.notes.clear();
    bench.session.bookmarks.clear();
    bench.session.unfreeze();
    change_scene(bench, std::make_shared<const Scene<2>>(std::move(scene)), gesture);
    change_view(bench, view, gesture);
    end_gesture(bench);
}

void save_scene(const Workbench<2>& bench, const std::string& file) {
    Scene<2> scene = bench.session.scene();
    scene.start_view = bench.session.culling_view();
    write_file(file, write_json(scene));
}

}  // namespace sightline
