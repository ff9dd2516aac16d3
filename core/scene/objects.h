// Objects: named groups of primitives (an OBJ group, a glTF node, a sector, a part), which engines cull as a whole.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/vec.h"

namespace sightline {

/// Every primitive belongs to one object. Plain names and numbers: what a primitive is, Scene says.
struct Objects {
    std::vector<std::string> names;  ///< each once, one line of text, none empty
    std::vector<std::uint32_t> of;   ///< per primitive: an index into names; empty where nothing is known of objects
    bool empty() const { return of.empty(); }
    bool operator==(const Objects&) const = default;
};

/// Drops objects without a primitive, keeps the others in their order, and makes names fit to be shown and typed: one
/// line, no control characters, "unnamed" where there is none, "wall (2)" for the second "wall".
void tidy(Objects& objects);

/// What hangs together by corners with equal coordinates, bit for bit: "part 1", … in the order of their first
/// primitive. For scenes that name no objects. Time O(n log n).
template <int D>
Objects connected_parts(const std::vector<std::array<Vec<D>, D>>& primitives);

/// The object with this name; none: there is no such object.
std::uint32_t object_named(const Objects& objects, std::string_view name);

/// The primitives of each object as compressed rows: those of object i are ids[first[i]] up to ids[first[i + 1]],
/// rising.
struct ObjectRows {
    std::vector<std::uint32_t> first, ids;
};
ObjectRows primitives_of_objects(const Objects& objects);

}  // namespace sightline
