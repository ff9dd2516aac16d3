// Levels of detail: for each object of a scene coarser ones that may be drawn in its place.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/space/cell_complex.h"
#include "core/space/facing.h"

namespace sightline {

/// Objects with fewer primitives have no levels, and there is none below one that has no more than half of it. Much of
/// what is drawn are small things: in a city of 100,000 triangles a third are parts of 8.
inline constexpr std::uint32_t least_object = 8;

/// One level of one object.
struct Level {
    std::uint32_t begin = 0, end = 0;  ///< of Levels::primitives
    /// In scene units. No point of the level lies farther from the object than this, and no point of the object farther
    /// from the level: an upper bound in 3D, the distance itself in 2D, but for rounding.
    double error = 0;

    std::uint32_t count() const { return end - begin; }
    bool operator==(const Level&) const = default;
};

/// Flat arrays. An object's levels stand one behind the other, the finest first; each has at most half of the
/// primitives of the one before it, in 2D three quarters, and a larger error. All of them lie inside the object's box.
template <int D>
struct Levels {
    Objects objects;                      ///< all_objects()
    ObjectRows rows;                      ///< their primitives
    std::vector<Box<D>> boxes;            ///< of the objects
    std::vector<Box<D>> group_boxes;      ///< around so many objects each, one after the other: group_size
    std::vector<std::uint32_t> first{0};  ///< per object and one more, into `levels`
    std::vector<Level> levels;
    std::vector<Primitive<D>> primitives;  ///< of all levels
    std::vector<std::uint8_t> two_sided;   ///< of them, as of a scene; 3D only
    FacingPlanes facing;                   ///< 3D: of the scene's primitives, in the order of rows.ids
    double milliseconds = 0;               ///< that making them took; decides nothing

    static constexpr std::uint32_t group_size = 16;

    std::uint32_t object_count() const { return static_cast<std::uint32_t>(boxes.size()); }
    std::span<const Level> of(std::uint32_t object) const {
        return std::span(levels).subspan(first[object], first[object + 1] - first[object]);
    }
    /// From 1, as StandIn counts them.
    const Level& at(std::uint32_t object, std::uint32_t level) const { return levels[first[object] + level - 1]; }
    std::span<const std::uint32_t> primitives_of(std::uint32_t object) const {
        return std::span(rows.ids).subspan(rows.first[object], rows.first[object + 1] - rows.first[object]);
    }
    std::size_t memory_bytes() const;
};

/// On up to so many threads (0: as many as the machine has), which decide nothing.
template <int D>
Levels<D> build_levels(const Scene<D>& scene, int threads = 0);

/// Of the scene that the cells were made for: built when first asked for, and kept with the cells.
template <int D>
std::shared_ptr<const Levels<D>> levels_of(const CellComplex<D>& cells, const Scene<D>& scene);

/// The primitives of the scene, and behind them those of the levels: primitive i of `levels` has the number
/// scene.primitives.size() + i. What draws levels draws primitives of this scene. Kept with the cells too.
template <int D>
std::shared_ptr<const Scene<D>> scene_with_levels(const CellComplex<D>& cells, const Scene<D>& scene);

}  // namespace sightline
