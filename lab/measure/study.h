// What a study measures: scenes, paths, methods and budgets. Plain data.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/methods/method_table.h"
#include "core/session/settings.h"

namespace sightline::lab {

/// A method on the cells that it runs on; orders of primitives do without cells.
struct MethodChoice {
    std::string variant;  ///< "published", "published on_reenqueue=min"
    Tessellation tessellation = Tessellation::delaunay;

    std::string id() const { return variant.substr(0, variant.find(' ')); }
    bool operator==(const MethodChoice&) const = default;
};

/// "published", or "published@tree" on the leaves of the quadtree or octree, or "published@kd" on those of the kd-tree,
/// all with parameters if you like: "published@tree on_reenqueue=min". Throws InputError for what the table of neither
/// dimension has.
MethodChoice parse_method(std::string_view text, const MethodTables& tables = {});
std::string method_text(const MethodChoice& choice);
/// Its cells as results and CSV name them, "delaunay", "tree" or "kd", and back. Throws InputError for another word.
std::string tessellation_word(const MethodChoice& choice);
Tessellation read_tessellation(std::string_view word);

/// Every row of the method table that is compared with others on Delaunay cells, and those that order cells on tree
/// cells too. Kd cells are measured where a study names them.
std::vector<MethodChoice> all_methods(const MethodTables& tables = {});

/// The method that draws exactly V, and the one that culls by the view alone: what studies hold others against.
inline constexpr const char *exactly_v = "perfect", *view_culling = "view";

/// nullptr when the table of the dimension does not have it.
template <int D>
const Method<D>* method_of(const MethodTables& tables, const MethodChoice& choice);

struct Study {
    MethodTables tables;
    std::vector<std::string> scenes;        ///< SceneName each; SCENE@PATH: along that path alone
    std::vector<std::string> paths = {""};  ///< find_path (lab_scene.h) each, for scenes without one of their own
    std::uint32_t frames = 0;               ///< so many, spread evenly over the path; 0: all
    std::vector<MethodChoice> methods = all_methods();
    /// For methods that have a use for one; others are measured without, once.
    std::vector<Budget> budgets = {parse_budget("1%"), parse_budget("2%"), parse_budget("5%"), parse_budget("10%")};
    std::vector<double> wrong_budgets;  ///< shares of wrong pixels that a budget is to follow (wrong_budget.h)
    std::vector<double> error_bounds;   ///< of the tessellation, one after the other; empty: each scene's own
    ImageSize size;                     ///< of the reference
    std::vector<std::string> settings;  ///< FIELD=VALUE for every scene, over what its catalogue row says
    std::uint32_t repeats = 3;          ///< timed runs a frame after one to warm up; 0: nothing is timed
};

/// Puts view culling and drawing exactly V beside the methods of a study that is without them.
void add_baselines(Study& study);

/// A scene of one dimension: "2d:bottleneck" or "3d:bottleneck". Without either, the dimension whose catalogue has the
/// name (3D where both do), else that of the kind of file (JSON, GeoJSON and WAD are 2D, folders and the rest 3D).
struct SceneName {
    int dimension = 3;
    std::string name;  ///< as load_scene takes it
};
SceneName parse_scene(const std::string& text);

/// One scene along one path.
struct SceneOnPath {
    std::string scene, path;
};
/// In the order of the study. A file that is there keeps an @ in its name.
std::vector<SceneOnPath> scenes_on_paths(const Study& study);

/// Frames of a path that follow one another, as "street:60-67" asks for.
struct PathPart {
    std::string path;
    std::uint32_t first = 0, last = 0;
};
/// Nothing for a name that asks for a whole path.
std::optional<PathPart> part_of_path(const std::string& name);

/// Whether OpenGL is needed.
bool has_3d(const Study& study);

/// The study with the tessellation of one of its error bounds; without any, as it is.
Study at_error_bound(const Study& study, double error_bound);

/// The study as JSON, one line: equal texts mean equal numbers but for times.
std::string study_json(const Study& study);
/// The other way round. Throws InputError for what study_json does not write.
Study read_study(std::string_view json, const MethodTables& tables = {});

}  // namespace sightline::lab
