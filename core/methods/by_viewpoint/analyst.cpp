// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/by_viewpoint/analyst.h"

#include <algorithm>

#include "core/base/random.h"
#include "core/base/trig.h"
#include "core/methods/coorg_teller/choose_occluders.h"
#include "core/scene/scene_view.h"

namespace sightline {

namespace {

/// Places that are tried for an eye that stands in the open.
constexpr int tries = 8;

std::uint64_t seed_of(std::uint32_t region, std::uint32_t interval) {
    return 0x5169'7468'6c69'6e65ull ^ (static_cast<std::uint64_t>(region) << 20 | interval);
}

template <int D>
Vec<D> place_in(const Box<D>& box, Random& random) {
    Vec<D> place;
    for (int a = 0; a < D; ++a) place[a] = random.uniform(box.min[a], box.max[a]);
    return place;
}

/// Whether rays along the axes meet fewer backs than fronts: one that stands in a house sees the backs of its walls.
template <int D>
bool is_in_the_open(const Scene<D>& scene, const RayTree& rays, const Vec<D>& eye) {
    int fronts = 0, backs = 0;
    if constexpr (D == 3)
        for (int a = 0; a < 3; ++a)
            for (const double sign : {-1.0, 1.0}) {
                Vec<3> ray(0);
                ray[a] = sign;
                const RayTree::Hit hit = rays.cast(eye, ray);
                if (!hit.any()) continue;
                const bool front = hit.front || shows_both_sides(scene, hit.triangle);
                ++(front ? fronts : backs);
            }
    return backs <= fronts;
}

/// Where the ray through corner i of the cone is at a distance of 1 ahead, relative to the eye.
template <int D>
Vec<D> corner_at_1(const View<D>& view, std::size_t i) {
    const Vec<D> ray = view.corners[i] - view.eye;
    return ray / glm::dot(ray, view.forward());
}

/// What the view sees at a distance of 1: a length in 2D, an area in 3D, as area-angles are measured.
double view_size(const View<2>& view) {
    if (view.all_round) return 2 * pi;
    const Vec<2> line = corner_at_1(view, 1) - corner_at_1(view, 0);
    return std::sqrt(glm::dot(line, line));
}
double view_size(const View<3>& view) {
    const Vec<3> corner = corner_at_1(view, 0);
    const Vec<3> area = glm::cross(corner_at_1(view, 1) - corner, corner_at_1(view, 3) - corner);
    return std::sqrt(glm::dot(area, area));
}

/// Over the views of an entry.
struct OccluderSums {
    double few = 0, all = 0, count = 0;
    std::vector<std::pair<double, std::uint32_t>> largest;  ///< area-angle and a primitive
};

template <int D>
void add_occluders(const ViewpointProblem<D>& p, const View<D>& view, OccluderSums& sums) {
    const Problem<D> problem{p.scene, p.cells, view, none, p.parameters, nullptr, {}};
    const auto of_scene = prepared<D>(problem);
    const std::vector<Candidate> found = potential_occluders<D>(*of_scene, *p.scene, view);
    double few = 0, all = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        all += found[i].area_angle;
        if (i >= p.choice.few) continue;
        few += found[i].area_angle;
        sums.largest.emplace_back(found[i].area_angle, of_scene->polygons.members_of(found[i].polygon).front());
    }
    const double size = view_size(view);
    sums.few += std::min(few / size, 1.0);
    sums.all += std::min(all / size, 1.0);
    sums.count += static_cast<double>(found.size());
}

/// Primitives of the largest ones, ascending.
std::vector<std::uint32_t> largest(std::vector<std::pair<double, std::uint32_t>> all, std::size_t count) {
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    std::vector<std::uint32_t> primitives;
    for (const auto& [area_angle, primitive] : all) {
        if (primitives.size() == count) break;
        if (std::find(primitives.begin(), primitives.end(), primitive) == primitives.end())
            primitives.push_back(primitive);
    }
    std::sort(primitives.begin(), primitives.end());
    return primitives;
}

}  // namespace

template <int D>
std::vector<ViewSpec<D>> Analyst<D>::views(std::uint32_t region, std::uint32_t interval) const {
    const ViewpointProblem<D>& p = *problem_;
    Random random(seed_of(region, interval));
    const Box<D> box = p.regions.box(region);
    std::vector<ViewSpec<D>> all(p.samples);
    for (ViewSpec<D>& view : all) {
        for (int i = 0; i < tries; ++i) {
            view.eye = place_in(box, random);
            // A box around rooms is what lies beside them.
            if (p.regions.at(view.eye) == region && (!p.rays || is_in_the_open(*p.scene, *p.rays, view.eye))) break;
        }
        const double across = random.unit(), up = random.unit();
        view.look_at = view.eye + p.directions.inside(interval, across, up);
        view.fov = p.fov;
    }
    return all;
}

template <int D>
const std::vector<DrawnSize>& Analyst<D>::drawn_sizes(const Run<D>& run, const View<D>& view) {
    const ViewpointProblem<D>& p = *problem_;
    const BoxTree<D>& tree = p.cells->boxes->of(*p.scene);
    drawn_of_.resize(tree.nodes.size());
    leaves_.clear();
    sizes_.clear();
    for_rendered(run.met(), [&](std::uint32_t primitive) {
        const std::uint32_t leaf = p.leaf_of[primitive];
        if (drawn_of_[leaf]++ == 0) leaves_.push_back(leaf);
    });
    const PixelScale<D> scale(view, image_size<D>(p.image));
    for (const std::uint32_t leaf : leaves_) {
        sizes_.push_back({D * static_cast<std::uint64_t>(drawn_of_[leaf]), scale.pixels_of(tree.nodes[leaf].box)});
        drawn_of_[leaf] = 0;
    }
    if (const auto stand_ins = run.stand_ins(); !stand_ins.empty()) {
        const std::shared_ptr<const Levels<D>> levels = run.levels();
        for (const StandIn& s : stand_ins)
            sizes_.push_back(
                {D * std::uint64_t{levels->at(s.object, s.level).count()}, scale.pixels_of(levels->boxes[s.object])});
    }
    return sizes_;
}

template <int D>
OptionCost Analyst<D>::cost(std::uint32_t option, const View<D>& view) {
    const ViewpointProblem<D>& p = *problem_;
    const Variant<D>& variant = p.options[option];
    Services services;
    services.image = p.image;
    services.threads = 1;
    std::shared_ptr<const FrameHistory> history;
    OwnRun<D>& run = runs_[option];
    // What the frame before decides is shown the same view twice: the second frame is the one that counts.
    for (int frame = variant.method.needs.keeps_lane() ? 0 : 1; frame < 2; ++frame) {
        run.start(
            make_problem<D>(variant.method, variant.parameters, *p.scene, *p.cells, view, none, services, history),
            variant.method.start);
        run->run(none);
        history = run->next_history();
    }
    const CullTime& time = p.cull_times[option];
    FrameDrawing frame(p.cost);
    for (const DrawnSize& size : drawn_sizes(*run, view)) frame.add(size);
    const Counters& counters = run->counters();
    return {static_cast<float>(time.ms(run->steps(), counters.touched_count)), static_cast<float>(frame.ms(p.reading)),
            static_cast<float>(counters.drawn())};
}

template <int D>
EntryFacts Analyst<D>::facts(std::uint32_t region, std::uint32_t interval) {
    const ViewpointProblem<D>& p = *problem_;
    std::vector<std::array<double, 3>> sums(p.options.size());
    OccluderSums occluders;
    for (const ViewSpec<D>& spec : views(region, interval)) {
        const View<D> view = scene_view(spec, *p.scene, p.image);
        for (std::uint32_t i = 0; i < p.options.size(); ++i) {
            const OptionCost one = cost(i, view);
            sums[i][0] += one.cull_ms;
            sums[i][1] += one.draw_ms;
            sums[i][2] += one.drawn;
        }
        add_occluders(p, view, occluders);
    }
    const double n = p.samples;
    EntryFacts facts;
    facts.interior = p.regions.is_room(region);
    for (const auto& sum : sums)
        facts.costs.push_back(
            {static_cast<float>(sum[0] / n), static_cast<float>(sum[1] / n), static_cast<float>(sum[2] / n)});
    facts.few_cover = static_cast<float>(occluders.few / n);
    facts.all_cover = static_cast<float>(occluders.all / n);
    facts.occluders = static_cast<std::uint32_t>(occluders.count / n + 0.5);
    facts.candidates = largest(std::move(occluders.largest), p.choice.few);
    return facts;
}

template class Analyst<2>;
template class Analyst<3>;

}  // namespace sightline
