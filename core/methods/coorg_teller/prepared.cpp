// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/prepared.h"

#include <algorithm>

#include "core/base/stopwatch.h"
#include "core/methods/coorg_teller/occluder_region.h"

namespace sightline {

namespace {

/// Puts polygons at the nodes of a tree of space. Nodes at its border reach as far out as one likes, so that an eye
/// outside it finds what it should.
template <int D>
class RegionPlacer {
public:
    explicit RegionPlacer(const Tree<D>& space) : space_(space), at_(space.nodes.size()) {}

    void place(std::uint32_t polygon, const Box<D>& region) { place(0, polygon, region); }

    void take(std::vector<std::uint32_t>& begin, std::vector<std::uint32_t>& polygons) {
        for (const auto& here : at_) {
            polygons.insert(polygons.end(), here.begin(), here.end());
            begin.push_back(static_cast<std::uint32_t>(polygons.size()));
        }
    }

private:
    void place(std::uint32_t node, std::uint32_t polygon, const Box<D>& region) {
        const Box<D>&box = space_.nodes[node].box, &root = space_.root_box();
        bool inside = true;
        for (int i = 0; i < D; ++i) {
            const bool open_below = box.min[i] == root.min[i], open_above = box.max[i] == root.max[i];
            if ((!open_below && region.max[i] < box.min[i]) || (!open_above && region.min[i] > box.max[i])) return;
            inside &= !open_below && region.min[i] <= box.min[i] && !open_above && region.max[i] >= box.max[i];
        }
        const std::uint32_t first = space_.nodes[node].first_child;
        if (first == none || inside || box.longest_side() <= region.longest_side()) {
            at_[node].push_back(polygon);
            return;
        }
        std::uint32_t count = 1;
        for (int i = 0; i < D; ++i) count <<= space_.splits(node, i);
        for (std::uint32_t child = first; child < first + count; ++child) place(child, polygon, region);
    }

    const Tree<D>& space_;
    std::vector<std::vector<std::uint32_t>> at_;
};

}  // namespace

template <int D>
std::vector<std::uint32_t> Prepared<D>::near(const Vec<D>& eye) const {
    std::vector<std::uint32_t> found;
    if (tree.space.nodes.empty()) return found;
    const auto take = [&](std::uint32_t node) {
        found.insert(found.end(), region_polygons.begin() + region_begin[node],
                     region_polygons.begin() + region_begin[node + 1]);
    };
    tree.space.walk_to_leaf(eye, take);
    return found;
}

template <int D>
std::size_t Prepared<D>::polygon_references() const {
    std::size_t count = 0;
    std::vector<std::uint32_t> last(polygons.size(), none);
    for (std::uint32_t node = 0; node < tree.boxes.nodes.size(); ++node) {
        if (tree.boxes.nodes[node].first_child != none) continue;
        for (const std::uint32_t primitive : tree.boxes.primitives_of(node)) {
            std::uint32_t& at = last[polygons.polygon_of[primitive]];
            count += at != node;
            at = node;
        }
    }
    return count;
}

template <int D>
Prepared<D> prepare(const Scene<D>& scene, TreeKind kind, std::uint32_t leaf, double threshold) {
    Prepared<D> made;
    Stopwatch clock;
    made.polygons = build_polygons(scene);
    made.milliseconds_polygons = clock.milliseconds();
    clock = {};
    made.tree = build_reference_tree(scene, kind, leaf, least_node_side);
    made.milliseconds_tree = clock.milliseconds();
    clock = {};
    made.threshold = threshold;
    RegionPlacer<D> placer(made.tree.space);
    for (std::uint32_t polygon = 0; polygon < made.polygons.size(); ++polygon)
        placer.place(polygon, occluder_region<D>(made.polygons.area[polygon], made.polygons.centre[polygon], threshold,
                                                 made.polygons.two_sided[polygon]));
    placer.take(made.region_begin, made.region_polygons);
    made.milliseconds_regions = clock.milliseconds();
    return made;
}

template <int D>
std::shared_ptr<const Prepared<D>> prepared(const Problem<D>& problem) {
    const Parameters& parameters = problem.parameters;
    const std::string text = "coorg-teller tree=" + std::string(parameters.text(tree_row())) +
                             " leaf=" + std::string(parameters.text(leaf_row())) +
                             " threshold=" + std::string(parameters.text(threshold_row()));
    return problem.cells->made->template of<Prepared<D>>(text, [&] {
        return prepare<D>(*problem.scene, parameters.choice<TreeKind>(tree_row()),
                          static_cast<std::uint32_t>(parameters.number(leaf_row())),
                          parameters.number(threshold_row()));
    });
}

#define SIGHTLINE_INSTANTIATE(D)                                                       \
    template struct Prepared<D>;                                                       \
    template Prepared<D> prepare<D>(const Scene<D>&, TreeKind, std::uint32_t, double); \
    template std::shared_ptr<const Prepared<D>> prepared<D>(const Problem<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
