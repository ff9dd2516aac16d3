// Techniques: what the paper on algorithm selection compares (DAS, table 1), and what is here beside it, as data.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/words.h"
#include "core/scene/scene.h"

namespace sightline {

// Columns of DAS, table 1. What it leaves empty is `any`.
enum class SceneMotion : std::uint8_t { static_only, any };
enum class ScenePlace : std::uint8_t { inside, outside, any };
enum class SceneStructure : std::uint8_t { soup, objects };
enum class SceneReach : std::uint8_t { any, near, far };

// What the gem (The Visibility Problem) classifies by. Simplified shows something else in place of what is there.
enum class FoundFrom : std::uint8_t { point, region };
enum class FoundIn : std::uint8_t { object_space, image_space };
enum class Finding : std::uint8_t { conservative, approximate, simplified };

template <>
inline constexpr auto words<SceneMotion> = std::to_array<std::string_view>({"STA", "DYN/STA"});
template <>
inline constexpr auto words<ScenePlace> = std::to_array<std::string_view>({"IN", "OUT", "IN/OUT"});
template <>
inline constexpr auto words<SceneStructure> = std::to_array<std::string_view>({"UNSTR", "STR"});
template <>
inline constexpr auto words<SceneReach> = std::to_array<std::string_view>({"", "NEAR", "FAR"});
template <>
inline constexpr auto words<FoundFrom> = std::to_array<std::string_view>({"point", "region"});
template <>
inline constexpr auto words<FoundIn> = std::to_array<std::string_view>({"object space", "image space"});
template <>
inline constexpr auto words<Finding> = std::to_array<std::string_view>({"conservative", "approximate", "simplified"});

/// A row. Texts are plain English and end without a full stop.
struct Technique {
    std::string_view id;        ///< as a method is called, in lower case
    std::string_view name;      ///< in the table: the paper's
    std::string_view category;  ///< path from the left of the table: "Visibility / Point Visibility / …"
    bool in_table;              ///< of DAS, table 1; else added here
    SceneMotion motion;
    ScenePlace place;
    SceneStructure structure;
    SceneReach reach;
    FoundFrom from;
    FoundIn in;
    Finding finding;
    std::string_view method;  ///< id in the table of methods; empty: absent
    std::string_view absent;  ///< why; empty where there is a method
    std::string_view source;
    std::string_view note;  ///< where the paper contradicts itself or we read it in our way; may be empty

    bool is_here() const { return !method.empty(); }
};

/// The rows of the table in its order, then those added here.
std::span<const Technique> techniques();

/// nullptr: there is none. Both its own id and that of its method are known.
const Technique* find_technique(std::string_view id);

enum class Suits : std::uint8_t { yes, in_part, no };
template <>
inline constexpr auto words<Suits> = std::to_array<std::string_view>({"suits", "suits in part", "does not suit"});

/// Whether a technique can do something for a scene as it is given, whether or not it is here.
struct Suitability {
    Suits suits;
    std::string reason;  ///< one sentence without its full stop
};
template <int D>
Suitability suitability(const Technique& technique, const Scene<D>& scene);

/// "DYN/STA, IN/OUT, STR, NEAR": what the table says of it.
std::string needs_words(const Technique& technique);
/// "conservative, from a point, in image space".
std::string finds_words(const Technique& technique);

/// The table of docs/methods.md, and the notes under it.
std::string techniques_markdown();

}  // namespace sightline
