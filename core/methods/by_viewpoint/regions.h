// The space that eyes move in, cut into regions: boxes of a grid, and the rooms that the scene marks (DAS figure 2).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace sightline {

/// Regions 0 to boxes() - 1 are the boxes, the first axis running fastest; behind them stands a region for each room,
/// which an eye in it belongs to and not to the box around it (DAS 3.1.2: a cell plays the part of a node). The scene
/// outlives it.
template <int D>
class Regions {
public:
    Regions() = default;
    /// `side` boxes along each axis, at least 1.
    Regions(const Scene<D>& scene, std::uint32_t side);

    std::uint32_t count() const { return boxes() + static_cast<std::uint32_t>(scene_->rooms.all.size()); }
    std::uint32_t boxes() const;
    std::uint32_t side() const { return side_; }
    bool is_room(std::uint32_t region) const { return region >= boxes(); }
    /// Total: an eye outside all boxes belongs to the nearest one.
    std::uint32_t at(const Vec<D>& eye) const;
    Box<D> box(std::uint32_t region) const;  ///< of a room: around it
    /// "room hall", "box 12"
    std::string words(std::uint32_t region) const;

private:
    std::uint32_t box_at(const Vec<D>& eye) const;

    const Scene<D>* scene_ = nullptr;
    std::uint32_t side_ = 1;
    Box<D> space_;
    std::vector<std::uint32_t> room_begin_{0}, rooms_;  ///< those that reach into each box
};

extern template class Regions<2>;
extern template class Regions<3>;

}  // namespace sightline
