// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/levels.h"

#include <algorithm>

#include "core/base/stopwatch.h"
#include "core/base/workers.h"
#include "core/space/object_levels.h"

namespace sightline {

namespace {

/// What is worked on in one go; enough that few large objects do not wait for each other.
constexpr std::uint32_t primitives_a_part = 4096;

/// Consecutive objects.
struct PartOfObjects {
    std::uint32_t begin = 0, end = 0;
};

std::vector<PartOfObjects> parts_of(const ObjectRows& rows) {
    std::vector<PartOfObjects> parts;
    const auto count = static_cast<std::uint32_t>(rows.first.size() - 1);
    for (std::uint32_t object = 0; object < count;) {
        PartOfObjects part{object, object};
        while (part.end < count &&
               (part.end == part.begin || rows.first[part.end] - rows.first[part.begin] < primitives_a_part))
            ++part.end;
        parts.push_back(part);
        object = part.end;
    }
    return parts;
}

}  // namespace

template <int D>
std::size_t Levels<D>::memory_bytes() const {
    std::size_t bytes = (objects.of.capacity() + rows.first.capacity() + rows.ids.capacity() + first.capacity()) *
                            sizeof(std::uint32_t) +
                        (boxes.capacity() + group_boxes.capacity()) * sizeof(Box<D>) +
                        levels.capacity() * sizeof(Level) + primitives.capacity() * sizeof(Primitive<D>) +
                        two_sided.capacity() + facing.memory_bytes();
    for (const std::string& name : objects.names) bytes += sizeof(name) + (name.size() > 15 ? name.capacity() : 0);
    return bytes;
}

template <int D>
Levels<D> build_levels(const Scene<D>& scene, int threads) {
    const Stopwatch clock;
    Levels<D> made;
    made.objects = all_objects(scene);
    made.rows = primitives_of_objects(made.objects);
    const auto count = static_cast<std::uint32_t>(made.rows.first.size() - 1);
    made.boxes.resize(count);
    const std::vector<PartOfObjects> parts = parts_of(made.rows);
    std::vector<ObjectLevels<D>> of_parts(parts.size());
    std::vector<std::uint32_t> level_count(count);
    run_parts(static_cast<int>(parts.size()), threads, [&](int i) {
        const PartOfObjects& part = parts[static_cast<std::size_t>(i)];
        ObjectLevels<D>& out = of_parts[static_cast<std::size_t>(i)];
        for (std::uint32_t object = part.begin; object < part.end; ++object) {
            const auto primitives = made.primitives_of(object);
            for (const std::uint32_t id : primitives)
                for (const Vec<D>& corner : scene.primitives[id]) made.boxes[object].add(corner);
            const std::size_t before = out.levels.size();
            if (primitives.size() >= least_object) append_levels(scene, primitives, out);
            level_count[object] = static_cast<std::uint32_t>(out.levels.size() - before);
        }
    });
    made.group_boxes.resize((count + Levels<D>::group_size - 1) / Levels<D>::group_size);
    for (std::uint32_t object = 0; object < count; ++object)
        made.group_boxes[object / Levels<D>::group_size].add(made.boxes[object]);
    std::size_t levels = 0, primitives = 0;
    for (const ObjectLevels<D>& part : of_parts) levels += part.levels.size(), primitives += part.primitives.size();
    made.levels.reserve(levels);
    made.primitives.reserve(primitives);
    made.first.reserve(std::size_t{count} + 1);
    for (const std::uint32_t n : level_count) made.first.push_back(made.first.back() + n);
    for (ObjectLevels<D>& part : of_parts) {
        const auto shift = static_cast<std::uint32_t>(made.primitives.size());
        for (const Level& level : part.levels)
            made.levels.push_back({level.begin + shift, level.end + shift, level.error});
        made.primitives.insert(made.primitives.end(), part.primitives.begin(), part.primitives.end());
        made.two_sided.insert(made.two_sided.end(), part.two_sided.begin(), part.two_sided.end());
        part = {};
    }
    if constexpr (D == 3) made.facing = FacingPlanes(scene, made.rows.ids);
    made.milliseconds = clock.milliseconds();
    return made;
}

template <int D>
std::shared_ptr<const Levels<D>> levels_of(const CellComplex<D>& cells, const Scene<D>& scene) {
    return cells.made->template of<Levels<D>>("levels", [&] { return build_levels(scene); });
}

template <int D>
std::shared_ptr<const Scene<D>> scene_with_levels(const CellComplex<D>& cells, const Scene<D>& scene) {
    const std::shared_ptr<const Levels<D>> levels = levels_of(cells, scene);
    return cells.made->template of<Scene<D>>("scene with levels", [&] {
        Scene<D> all;
        all.id = scene.id;
        all.title = scene.title;
        all.up_axis = scene.up_axis;
        all.origin = scene.origin;
        all.objects = levels->objects;
        const std::size_t count = scene.primitives.size() + levels->primitives.size();
        all.primitives.reserve(count);
        all.primitives = scene.primitives;
        all.primitives.insert(all.primitives.end(), levels->primitives.begin(), levels->primitives.end());
        all.objects.of.resize(count);
        for (std::uint32_t object = 0; object < levels->object_count(); ++object)
            for (const Level& level : levels->of(object))
                for (std::uint32_t i = level.begin; i < level.end; ++i)
                    all.objects.of[scene.primitives.size() + i] = object;
        if (D == 3) {
            all.two_sided = scene.two_sided;
            all.two_sided.resize(scene.primitives.size());
            all.two_sided.insert(all.two_sided.end(), levels->two_sided.begin(), levels->two_sided.end());
        }
        return all;
    });
}

#define SIGHTLINE_INSTANTIATE(D)                                                                    \
    template struct Levels<D>;                                                                      \
    template Levels<D> build_levels<D>(const Scene<D>&, int);                                       \
    template std::shared_ptr<const Levels<D>> levels_of<D>(const CellComplex<D>&, const Scene<D>&); \
    template std::shared_ptr<const Scene<D>> scene_with_levels<D>(const CellComplex<D>&, const Scene<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
