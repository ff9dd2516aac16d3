// Makes the list of hashes. No test framework here: a program built by another compiler makes the same list.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/run/golden_hashes.h"

#include <map>
#include <sstream>

#include "core/methods/method_table.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/scene_view.h"
#include "core/session/settings_table.h"
#include "core/session/start_settings.h"
#include "core/space/builders.h"

namespace sightline::test {

namespace {

/// Large enough for furnished houses, small enough for a test of seconds.
constexpr std::size_t triangles_3d = 10'000;

struct RunHash {
    std::uint32_t steps = 0;
    std::uint64_t state = 0;
};

/// The one place that knows how a method is run: from the start until the settings' budget ends it.
template <int D>
RunHash run_hash(const Scene<D>& scene, const CellComplex<D>& cells, const View<D>& view, const Method<D>& method,
                 const Settings& settings) {
    const auto run = method.start(make_problem(method, settings.parameters, scene, cells, view,
                                               settings.budget.primitives(scene.primitives.size())));
    run->run(none);
    return {run->steps(), run->hash()};
}

Scene<2> small_scene(const CatalogueRow<2>& row) { return make_scene(row); }
Scene<3> small_scene(const CatalogueRow<3>& row) { return make_scene(row, triangles_3d); }

template <int D>
void add(Hash& hash, const Vec<D>& v) {
    for (int i = 0; i < D; ++i) hash.add(v[i]);
}

/// Geometry, links and assignment, not what only finds them faster.
template <int D>
std::uint64_t cells_hash(const CellComplex<D>& cells) {
    Hash hash;
    hash.add(cells.points.size());
    for (const Vec<D>& point : cells.points) add<D>(hash, point);
    for (const HalfFacet& half : cells.half_facets) {
        hash.add(half.neighbour);
        hash.add(half.facet_side);
    }
    for (const auto* indices : {&cells.cell_points, &cells.cell_facet_begin, &cells.facet_points, &cells.border_cells,
                                &cells.cell_primitive_begin, &cells.cell_primitives, &cells.tree.leaves}) {
        hash.add(indices->size());
        for (const std::uint32_t index : *indices) hash.add(index);
    }
    for (const auto& node : cells.tree.nodes) {
        add<D>(hash, node.box.min);
        add<D>(hash, node.box.max);
        hash.add(node.first_child);
    }
    for (const std::uint32_t number : {cells.rho_max, cells.rho_p95, cells.unassigned}) hash.add(number);
    return hash.value();
}

/// The hashes of one scene; `lines` grows.
template <int D>
struct Maker {
    const Scene<D> scene;
    const std::string name;
    const View<D> view;
    std::vector<std::string>& lines;

    Maker(const CatalogueRow<D>& row, std::vector<std::string>& to)
        : scene(small_scene(row)),
          name((D == 2 ? "2d " : "3d ") + std::string(row.id)),
          view(scene_view(scene.start_view.value(), scene, Settings{}.reference_size)),
          lines(to) {}

    /// What a viewer starts the scene with, and `assignments`.
    Settings settings(Tessellation tessellation, const std::string& assignments = "") const {
        Settings made = catalogue_settings<D>(scene.id);
        made.tessellation = tessellation;
        std::istringstream words(assignments);
        for (std::string word; words >> word;) apply_setting(made, word);
        return made;
    }

    void add_line(const std::string& key, const std::string& value) { lines.push_back(name + key + ": " + value); }

    /// A run within 5 % of the primitives, and one to the end.
    void add_run(const std::string& key, const CellComplex<D>& cells, Settings settings) {
        const Method<D>& method = find_method<D>(method_table<D>(), settings.method);
        std::string value;
        for (const char* budget : {"5%", "unlimited"}) {
            settings.budget = parse_budget(budget);
            const RunHash run = run_hash<D>(scene, cells, view, method, settings);
            value += (value.empty() ? "" : ", ") + std::string(budget) + " " + hash_text(run.state) + " after " +
                     std::to_string(run.steps);
        }
        add_line(key, value);
    }

    void add_scene() { add_line("", hash_text(scene_hash(scene)) + " " + std::to_string(scene.primitives.size())); }

    void add_methods() {
        for (const Tessellation tessellation : {Tessellation::delaunay, Tessellation::tree, Tessellation::kd}) {
            const std::string key = " " + std::string(words<Tessellation>[static_cast<std::size_t>(tessellation)]);
            Settings start = settings(tessellation);
            const CellComplex<D> cells = build_cells(scene, start);
            add_line(key, hash_text(cells_hash(cells)) + " " + std::to_string(cells.cell_count()));
            for (const Method<D>& method : method_table<D>()) {
                if (!method.compared) continue;           // asks for more than the scene
                if (method.pops == Kind::node) continue;  // the same on all cells: add_boxes
                if (tessellation == Tessellation::kd && !method.orders_cells()) continue;  // the same on all cells
                start.method = method.id;
                add_run(key + " " + start.method, cells, start);
            }
        }
    }

    /// Methods that walk the tree of boxes, or from room to room where the scene marks some; depth images of 320 x 240
    /// pixels, lines of 2048.
    void add_boxes() {
        const Settings start = settings(Tessellation::delaunay);
        const CellComplex<D> cells = build_cells(scene, start);
        std::vector<const char*> texts{"view",
                                       "boxes refresh=16",
                                       "hzb",
                                       "hom",
                                       "two-pass occluders=plp",
                                       "coorg-teller connected=on",
                                       "coorg-teller connected=grow leaves=polygons",
                                       "shadow-frusta"};
        if (!scene.rooms.empty()) texts.insert(texts.end(), {"portals", "pvs", "by-viewpoint grid=2 samples=1"});
        for (const char* text : texts) {
            const Variant<D> variant = make_variant<D>(method_table<D>(), text, start.parameters);
            Services services;
            services.image = D == 2 ? ImageSize{2048, 0} : ImageSize{320, 240};
            std::string value;
            for (const char* budget : {"5%", "unlimited"}) {
                const std::uint32_t primitives = parse_budget(budget).primitives(scene.primitives.size());
                const auto run = variant.method.start(
                    make_problem(variant.method, variant.parameters, scene, cells, view, primitives, services));
                run->run(none);
                value += (value.empty() ? "" : ", ") + std::string(budget) + " " + hash_text(run->hash()) + " after " +
                         std::to_string(run->steps());
            }
            add_line((variant.method.pops == Kind::node ? " boxes " : " rooms ") + std::string(text), value);
        }
    }

    /// `published` under settings that few scenes start with.
    void add_settings() {
        for (const Tessellation tessellation : {Tessellation::delaunay, Tessellation::tree})
            for (const char* assignments :
                 {"on_reenqueue=min", "on_reenqueue=max", "penalty=add", "penalty=none", "transfer_sign=signed",
                  "view_vector=camera", "outside_view=enqueue", "culled_cost=charged", "neighbours_before_break=no",
                  "seeds=hull", "border=none seeds=hull", "solidity_scale=p95 penalty=add", "star_shaped=off",
                  "own_content=on", "budget_counts=per_cell", "leaf_capacity=8",
                  tessellation == Tessellation::tree ? "neighbours=touching" : "empty_leaves=drop"}) {
                Settings start = settings(tessellation, assignments);
                start.method = "published";
                const std::string key = std::string(words<Tessellation>[static_cast<std::size_t>(tessellation)]);
                add_run(" " + key + " published " + assignments, build_cells(scene, start), start);
            }
    }

    /// Light that comes to corners, and through facets.
    void add_transports() {
        for (const Tessellation tessellation : {Tessellation::delaunay, Tessellation::tree})
            for (const char* method : {"flux", "tri"})
                for (const char* transport : {"facets", "corners"}) {
                    Settings start = settings(tessellation, std::string("transport=") + transport);
                    start.method = method;
                    const std::string key = std::string(words<Tessellation>[static_cast<std::size_t>(tessellation)]);
                    add_run(" " + key + " " + method + " transport=" + transport, build_cells(scene, start), start);
                }
    }
};

template <int D>
void add_hashes(std::vector<std::string>& lines) {
    for (const auto rows : {catalogue<D>(), failure_scenes<D>()})
        for (const CatalogueRow<D>& row : rows) {
            Maker<D> maker(row, lines);
            maker.add_scene();
            maker.add_methods();
            maker.add_boxes();
        }
    // Seen from within, from outside, and with cells out of view.
    for (const char* id : {"bottleneck", "warehouse", "jungle"}) {
        Maker<D> maker(*find_in_catalogue<D>(id), lines);
        maker.add_settings();
        maker.add_transports();
    }
}

std::string key_of(const std::string& line) { return line.substr(0, line.find(": ")); }

}  // namespace

std::vector<std::string> golden_hashes() {
    std::vector<std::string> lines;
    add_hashes<2>(lines);
    add_hashes<3>(lines);
    return lines;
}

std::vector<std::string> changed_lines(const std::string& held, const std::vector<std::string>& wanted) {
    std::map<std::string, std::string> left;
    std::istringstream text(held);
    for (std::string line; std::getline(text, line);)
        if (!line.empty() && line[0] != '#') left[key_of(line)] = line;
    std::vector<std::string> changed;
    for (const std::string& line : wanted) {
        const auto found = left.find(key_of(line));
        if (found == left.end() || found->second != line) changed.push_back(line);
        if (found != left.end()) left.erase(found);
    }
    for (const auto& [key, line] : left) changed.push_back("no longer: " + key);
    return changed;
}

}  // namespace sightline::test
