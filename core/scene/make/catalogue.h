// The scenes that come with the program: an explicit table, shared by viewers, tests and benchmarks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/scene/scene.h"

namespace sightline {

/// A setting that the scene's lesson starts with and that differs from the default; both as on the command line.
struct SettingOverride {
    const char* field;
    const char* value;
};

/// A place in the traversal worth stopping at; the condition is one that --until takes.
struct CatalogueBookmark {
    const char* condition;
    const char* label;
};

/// What a 3D generator makes. Coordinates are float values, z is up, lengths are metres.
struct Generated {
    std::vector<Primitive<3>> triangles;
    std::vector<std::uint8_t> two_sided;  ///< as Scene::two_sided
    std::vector<FlightPath<3>> paths;     ///< the last is "test", of 8 frames
    Objects objects{};                    ///< empty: those parts that hang together
    Rooms<3> rooms{};
};

/// 2D scenes have one size. 3D: `triangles` is what to come close to; scenes of a fixed size ignore it.
template <int D>
using Generate = std::conditional_t<D == 2, std::vector<Primitive<2>> (*)(std::uint64_t seed),
                                    Generated (*)(std::uint64_t seed, std::size_t triangles)>;

template <int D>
struct CatalogueRow {
    const char* id;
    std::uint64_t seed;
    const char* title;
    const char* lesson;  ///< one sentence for students
    Generate<D> generate;
    ViewSpec<D> view;
    double error_bound;  ///< the largest side of a leaf, as a share of the longest side of the scene
    const char* method;  ///< id of the method to start with
    const char* budget;  ///< as --budget takes it
    std::vector<SettingOverride> settings;
    std::vector<CatalogueBookmark> bookmarks;
    std::size_t triangles;           ///< 3D: how many unless the name says otherwise; 0: the size is fixed, as in 2D
    std::vector<const char*> paths;  ///< 3D: ids of its flight paths; 2D: none
    /// 2D: its rooms, where the generator knows them; nullptr: it marks none. In 3D it makes them with the triangles.
    std::conditional_t<D == 2, Rooms<2> (*)(std::uint64_t seed), std::nullptr_t> rooms = nullptr;
};

/// How many triangles a name may ask for: from 10,000 on, or from what the scene has otherwise if that is less.
inline constexpr std::size_t most_triangles = 16'000'000;
std::size_t fewest_triangles(const CatalogueRow<3>& row);

/// All rows, in the order in which a lecture would show them.
template <int D = 2>
std::span<const CatalogueRow<D>> catalogue();
template <>
std::span<const CatalogueRow<2>> catalogue<2>();
template <>
std::span<const CatalogueRow<3>> catalogue<3>();

/// Small scenes in which methods fail (field-notes D), by the number of the failure: rows of the catalogue that no
/// lecture shows and `lab gallery` measures. Their primitives may be what a catalogue should not hold: none, or broken
/// ones.
template <int D>
std::span<const CatalogueRow<D>> failure_scenes();
template <>
std::span<const CatalogueRow<2>> failure_scenes<2>();
template <>
std::span<const CatalogueRow<3>> failure_scenes<3>();

/// Of both tables; nullptr when no row has this id; in 3D a size may follow it.
template <int D = 2>
const CatalogueRow<D>* find_in_catalogue(std::string_view id);

/// The row's scene, cleaned; origin 0, source "generated". The same bits on every machine.
Scene<2> make_scene(const CatalogueRow<2>& row);
/// As above, with paths; within 5 % of `triangles`, which counts only in rows that have a size.
Scene<3> make_scene(const CatalogueRow<3>& row, std::size_t triangles);

/// "city", or with a size "city:500k", "city:16M", "city:20000". Nothing when what stands before the colon is no id of
/// the 3D catalogue; throws InputError when what stands behind it is no size that the scene can have. `seed`: another
/// than the row's, for what is measured over several.
std::optional<Scene<3>> generated_scene(std::string_view name, std::optional<std::uint64_t> seed = std::nullopt);

}  // namespace sightline
