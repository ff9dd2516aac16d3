// What a method renders in each frame of a path, by primitive and by object.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/objects.h"
#include "core/truth/id_image.h"
#include "lab/measure/lab_scene.h"

namespace sightline::lab {

/// One primitive that is visible, rendered or both.
struct SetEntry {
    std::uint32_t primitive = 0;
    bool visible = false, rendered = false;
    std::uint32_t pixels = 0;  ///< of the exact image that show it

    bool missed() const { return visible && !rendered; }
    /// Pixels that show something else because it is not rendered.
    std::uint32_t wrong() const { return rendered ? 0 : pixels; }
};

struct FrameSets {
    std::uint32_t frame = 0;           ///< of the path
    std::vector<SetEntry> entries;     ///< by primitive
    std::vector<std::uint32_t> order;  ///< the rendered ones as they were rendered
    std::size_t image_pixels = 0;      ///< of the exact image, empty ones too
};

struct PathSets {
    std::string method, budget, reference;  ///< `reference` as in Row
    Objects objects;                        ///< the scene's, else its connected parts
    std::vector<FrameSets> frames;
};

/// Sums over the entries of an object in a frame.
struct ObjectSet {
    std::uint32_t object = 0;
    std::uint32_t visible = 0, rendered = 0, missed = 0, extra = 0;  ///< extra: rendered though not visible
    std::uint64_t pixels = 0, wrong = 0;
};
/// Those with an entry, by their index.
std::vector<ObjectSet> by_object(const FrameSets& frame, const Objects& objects);

/// Of one method at one budget, frame by frame; `go_on(frames done)` false ends it early.
template <int D>
PathSets path_sets(const LabScene<D>& lab, const MethodChoice& method, const Budget& budget, const DrawIds& draw_ids,
                   const std::function<bool(std::size_t)>& go_on = {});

/// docs/measuring.md names the columns and fields.
std::string primitives_csv(const PathSets& sets);
std::string objects_csv(const PathSets& sets);
template <int D>
std::string sets_json(const PathSets& sets, const LabScene<D>& lab);

}  // namespace sightline::lab
