// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/by_viewpoint/regions.h"

#include <algorithm>

namespace sightline {

namespace {

/// Beyond what is drawn, as a share of its longest side: an eye may stand outside and look in.
constexpr double margin = 0.05;

Box<2> box_of(const Room<2>& room) {
    Box<2> box;
    for (const Vec<2>& corner : room.shape) box.add(corner);
    return box;
}
Box<3> box_of(const Room<3>& room) { return room.shape; }

template <int D>
bool overlap(const Box<D>& a, const Box<D>& b) {
    for (int i = 0; i < D; ++i)
        if (a.min[i] > b.max[i] || b.min[i] > a.max[i]) return false;
    return true;
}

/// Around all that is drawn and all eyes that the scene itself names.
template <int D>
Box<D> space_of(const Scene<D>& scene) {
    Box<D> space = bounds<D>(scene.primitives);
    for (const FlightPath<D>& path : scene.paths)
        for (const ViewSpec<D>& frame : path.frames) space.add(frame.eye);
    if (scene.start_view) space.add(scene.start_view->eye);
    if (space.empty()) return {Vec<D>(0), Vec<D>(1)};
    const Vec<D> extent = space.extent();
    double longest = 0;
    for (int a = 0; a < D; ++a) longest = std::max(longest, extent[a]);
    const double more = longest > 0 ? margin * longest : 1;
    return {space.min - Vec<D>(more), space.max + Vec<D>(more)};
}

}  // namespace

template <int D>
Regions<D>::Regions(const Scene<D>& scene, std::uint32_t side) : scene_(&scene), side_(side), space_(space_of(scene)) {
    for (std::uint32_t region = 0; region < boxes(); ++region) {
        for (std::uint32_t room = 0; room < scene.rooms.all.size(); ++room)
            if (overlap(box(region), box_of(scene.rooms.all[room]))) rooms_.push_back(room);
        room_begin_.push_back(static_cast<std::uint32_t>(rooms_.size()));
    }
}

template <int D>
std::uint32_t Regions<D>::boxes() const {
    return D == 2 ? side_ * side_ : side_ * side_ * side_;
}

template <int D>
std::uint32_t Regions<D>::box_at(const Vec<D>& eye) const {
    std::uint32_t region = 0;
    for (int a = D - 1; a >= 0; --a) {
        const double place = (eye[a] - space_.min[a]) / (space_.max[a] - space_.min[a]) * side_;
        const double last = side_ - 1.0;
        region = region * side_ + static_cast<std::uint32_t>(place > 0 ? std::min(place, last) : 0);
    }
    return region;
}

template <int D>
std::uint32_t Regions<D>::at(const Vec<D>& eye) const {
    const std::uint32_t region = box_at(eye);
    for (std::uint32_t i = room_begin_[region]; i < room_begin_[region + 1]; ++i)
        if (holds(scene_->rooms.all[rooms_[i]], eye)) return boxes() + rooms_[i];
    return region;
}

template <int D>
Box<D> Regions<D>::box(std::uint32_t region) const {
    if (is_room(region)) return box_of(scene_->rooms.all[region - boxes()]);
    const Vec<D> extent = space_.extent() / static_cast<double>(side_);
    Box<D> box;
    box.min = space_.min;
    for (int a = 0; a < D; ++a) {
        box.min[a] += extent[a] * (region % side_);
        box.max[a] = box.min[a] + extent[a];
        region /= side_;
    }
    return box;
}

template <int D>
std::string Regions<D>::words(std::uint32_t region) const {
    return is_room(region) ? "room " + scene_->rooms.all[region - boxes()].name : "box " + std::to_string(region);
}

template class Regions<2>;
template class Regions<3>;

}  // namespace sightline
