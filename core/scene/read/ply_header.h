// The header of a PLY file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sightline {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };
enum class PlyFormat : std::uint8_t { text, little_endian, big_endian };

std::size_t bytes_of_type(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;    ///< of the value, or of what the list holds
    bool is_list;    ///< of as many values as a number before them says
    PlyType counts;  ///< the type of that number
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// The property's number; properties.size() where there is none.
    std::size_t find(std::string_view name) const;
    /// The list of vertices of a face.
    std::size_t indices() const;
    bool has_indices() const { return indices() < properties.size(); }
};

struct PlyHeader {
    PlyFormat format = PlyFormat::text;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;  ///< of the header

    const PlyElement* find(std::string_view element) const;
};

/// Throws InputError "line 3: reason".
PlyHeader ply_header(std::string_view file);

}  // namespace sightline
