// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/stability/stability.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/number.h"
#include "core/base/random.h"
#include "core/base/trig.h"
#include "core/measure/frame_change.h"
#include "core/scene/scene_view.h"
#include "core/session/settings_table.h"
#include "core/space/builders.h"
#include "core/truth/software_ids.h"
#include "core/truth/truth.h"
#include "lab/one_run.h"

namespace sightline::lab {

namespace {

using Set = std::vector<std::uint8_t>;

double coverage_of(const Set& visible, const Set& rendered) {
    std::size_t count = 0, found = 0;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        count += visible[i];
        found += visible[i] & rendered[i];
    }
    return count == 0 ? 1 : static_cast<double>(found) / static_cast<double>(count);
}

/// What a method makes of a frame, in the ids of the undisturbed scene.
struct Outcome {
    std::vector<std::uint32_t> order;  ///< rendered primitives
    Set rendered;
    double coverage = 0;
    std::size_t not_finite = 0;
};

template <int D>
Outcome outcome(std::span<const Method<D>> methods, const Scene<D>& scene, const CellComplex<D>& cells,
                const Settings& settings, const View<D>& view, const Services& services,
                std::span<const std::uint32_t> original) {
    OneRun run = one_run<D>(methods, scene, cells, view, settings, services);
    Outcome result{std::move(run.order), std::move(run.rendered), 0, run.not_finite};
    if (original.empty()) return result;
    std::fill(result.rendered.begin(), result.rendered.end(), std::uint8_t{0});
    for (std::uint32_t& id : result.order) {
        id = original[id];
        result.rendered[id] = 1;
    }
    return result;
}

template <int D>
class StabilityStudy {
public:
    StabilityStudy(const LabScene<D>& lab, const Study& study, const StabilityOptions& options, const DrawIds& draw_ids)
        : lab_(lab), options_(options), draw_ids_(drawing_of(lab.settings.reference, draw_ids)), random_(options.seed) {
        size_ = bounds<D>(lab.scene->primitives).longest_side();
        for (const MethodChoice& choice : study.methods) {
            const Method<D>* const method = method_of<D>(lab.tables, choice);
            // One that has no use for a budget renders what the view holds: nothing to be unstable.
            if (!method || !method->budgeted) continue;
            for (const Budget& budget : study.budgets) methods_.push_back({choice, budget, method->needs.visible_set});
        }
    }

    std::vector<StabilityRow> run(const StabilityWatch& watch) {
        if (methods_.empty() || lab_.scene->primitives.empty()) return {};
        const std::vector<Stage> all = stages();
        double views = 0;
        for (const Stage& stage : all) views += stage.views;
        std::vector<StabilityRow> rows;
        for (const Stage& stage : all) {
            StabilityStage done{stage.name, stage.views / views, {}};
            auto finished = watch.finished ? watch.finished(stage.name) : std::nullopt;
            done.rows = finished ? std::move(*finished) : measure(stage);
            rows.insert(rows.end(), done.rows.begin(), done.rows.end());
            if (watch.stage_done && !watch.stage_done(done)) break;
        }
        const auto place = [&](const StabilityRow& row) {
            const auto at = std::find_if(methods_.begin(), methods_.end(), [&](const Choice& choice) {
                return choice.method == row.method && budget_text(choice.budget) == row.budget;
            });
            return std::tuple(at - methods_.begin(), row.disturbance, row.amount);
        };
        std::sort(rows.begin(), rows.end(),
                  [&](const StabilityRow& a, const StabilityRow& b) { return place(a) < place(b); });
        return rows;
    }

private:
    struct Choice {
        MethodChoice method;
        Budget budget;
        bool needs_set;
    };
    struct Stage {
        std::string name;
        double views;  ///< in which every method runs
        std::function<void()> measure;
    };
    struct Base {
        Set visible;
        std::vector<Outcome> of;  ///< per method
    };
    struct Sum {
        StabilityRow row;
        std::vector<double> coverages;
    };

    std::vector<Stage> stages() {
        const auto spots = static_cast<double>(lab_.specs.size()), samples = spots * options_.repeats;
        std::vector<Stage> all;
        for (const double amount : {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
            all.push_back({"eye moved by " + amount_text(amount), samples, [=, this] { move_eye(amount); }});
        all.push_back({"other orders of the primitives", samples, [this] {
                           for (std::uint32_t i = 0; i < options_.repeats; ++i) shuffle();
                       }});
        for (const double factor : {0x1p-20, 0x1p-1, 0x1p1, 0x1p20, 1e-6, 1e6})
            all.push_back({"everything times " + amount_text(factor), spots,
                           [=, this] { transform(Disturbance::scale, factor, factor, 0); }});
        all.push_back({"everything moved by 1e6", spots, [this] { transform(Disturbance::offset, 1e6, 1, 1e6); }});
        all.push_back({"other jitter seeds", samples, [this] {
                           for (std::uint32_t i = 0; i < options_.repeats; ++i) jitter(lab_.settings.seed + 1 + i);
                       }});
        all.push_back({"past a wall", 2 * graze_steps + 1, [this] { graze(); }});
        return all;
    }

    std::vector<StabilityRow> measure(const Stage& stage) {
        if (base_.empty())
            for (std::size_t frame = 0; frame < lab_.specs.size(); ++frame) base_.push_back(base_of(frame));
        Hash seed;
        seed.add(options_.seed);
        for (const char c : stage.name) seed.add(c);
        random_ = Random(seed.value());
        sums_.clear();
        stage.measure();
        return rows();
    }

    Settings settings_of(const Choice& choice, const Settings& from) const {
        Settings settings = from;
        settings.method = choice.method.variant;
        settings.tessellation = choice.method.tessellation;
        settings.budget = choice.budget;
        return settings;
    }

    /// All methods in one view; their coverage is against `visible`.
    std::vector<Outcome> outcomes(const Scene<D>& scene,
                                  const std::array<std::optional<CellComplex<D>>, tessellation_count>& cells,
                                  const Settings& settings, const View<D>& view, const Set& visible,
                                  std::span<const std::uint32_t> original = {}) const {
        std::vector<Outcome> all(methods_.size());
        const Services services = exact_services(scene, view, settings.reference_size, draw_ids_);
        if (std::any_of(methods_.begin(), methods_.end(), [](const Choice& choice) { return choice.needs_set; }))
            services.visible_set();  // here: OpenGL is of this thread
        tbb::parallel_for(std::size_t{0}, methods_.size(), [&](std::size_t m) {
            const auto& on = *cells[static_cast<std::size_t>(methods_[m].method.tessellation)];
            all[m] = outcome<D>(lab_.tables.template of<D>(), scene, on, settings_of(methods_[m], settings), view,
                                services, original);
            all[m].coverage = coverage_of(visible, all[m].rendered);
        });
        return all;
    }

    Base base_of(std::size_t frame) const {
        Base base;
        base.visible = visible_set(*lab_.scene, lab_.views[frame], lab_.settings.reference_size, draw_ids_);
        base.of = outcomes(*lab_.scene, lab_.cells, lab_.settings, lab_.views[frame], base.visible);
        return base;
    }

    void add(Disturbance disturbance, double amount, const std::vector<Outcome>& before,
             const std::vector<Outcome>& after, double visible_jaccard) {
        for (std::size_t m = 0; m < methods_.size(); ++m) {
            Sum& sum = sums_[{m, disturbance, amount}];
            StabilityRow& row = sum.row;
            const double same = jaccard(before[m].rendered, after[m].rendered);
            const auto n = static_cast<double>(row.samples);
            const auto mean = [&](double old, double value) { return (old * n + value) / (n + 1); };
            row.jaccard = row.samples == 0 ? same : mean(row.jaccard, same);
            row.jaccard_min = row.samples == 0 ? same : std::min(row.jaccard_min, same);
            row.coverage_change = mean(row.coverage_change, std::abs(before[m].coverage - after[m].coverage));
            row.visible_jaccard = row.samples == 0 ? visible_jaccard : mean(row.visible_jaccard, visible_jaccard);
            row.equal &= before[m].order == after[m].order;
            row.not_finite += after[m].not_finite;
            ++row.samples;
            sum.coverages.push_back(after[m].coverage);
        }
    }

    Vec<D> random_direction() {
        for (;;) {
            Vec<D> d{};
            for (int i = 0; i < D; ++i) d[i] = random_.uniform(-1, 1);
            const double length = std::sqrt(glm::dot(d, d));
            if (length > 0.1 && length <= 1) return d / length;
        }
    }

    void move_eye(double amount) {
        for (std::size_t frame = 0; frame < lab_.specs.size(); ++frame)
            for (std::uint32_t i = 0; i < options_.repeats; ++i) {
                ViewSpec<D> spec = lab_.specs[frame];
                const Vec<D> by = random_direction() * (amount * size_);
                spec.eye += by;
                spec.look_at += by;
                const View<D> view = scene_view(spec, *lab_.scene, lab_.settings.reference_size);
                const Set visible = visible_set(*lab_.scene, view, lab_.settings.reference_size, draw_ids_);
                add(Disturbance::eye, amount, base_[frame].of,
                    outcomes(*lab_.scene, lab_.cells, lab_.settings, view, visible),
                    jaccard(base_[frame].visible, visible));
            }
    }

    /// Runs on another scene, whose exact set is that of the undisturbed one.
    void compare(Disturbance disturbance, double amount, const Scene<D>& scene, const Settings& settings,
                 std::span<const std::uint32_t> original, const std::function<ViewSpec<D>(ViewSpec<D>)>& moved) {
        std::array<std::optional<CellComplex<D>>, tessellation_count> cells;
        for (std::size_t t = 0; t < tessellation_count; ++t)
            if (lab_.cells[t]) {
                Settings s = settings;
                s.tessellation = static_cast<Tessellation>(t);
                cells[t] = build_cells(scene, s);
            }
        for (std::size_t frame = 0; frame < lab_.specs.size(); ++frame)
            add(disturbance, amount, base_[frame].of,
                outcomes(scene, cells, settings, scene_view(moved(lab_.specs[frame]), scene, settings.reference_size),
                         base_[frame].visible, original),
                1);
    }

    void shuffle() {
        std::vector<std::uint32_t> original(lab_.scene->primitives.size());
        std::iota(original.begin(), original.end(), 0u);
        for (std::size_t i = original.size(); i > 1; --i) std::swap(original[i - 1], original[random_.below(i)]);
        Scene<D> scene = *lab_.scene;
        for (std::size_t i = 0; i < original.size(); ++i) {
            scene.primitives[i] = lab_.scene->primitives[original[i]];
            copy_facts(*lab_.scene, original[i], scene, i);
        }
        compare(Disturbance::shuffle, 0, scene, lab_.settings, original, [](ViewSpec<D> spec) { return spec; });
    }

    void transform(Disturbance disturbance, double amount, double factor, double offset) {
        const auto moved = [&](const Vec<D>& p) { return p * factor + Vec<D>(offset); };
        Scene<D> scene = *lab_.scene;
        for (Primitive<D>& primitive : scene.primitives)
            for (Vec<D>& p : primitive) p = moved(p);
        compare(disturbance, amount, scene, lab_.settings, {}, [&](ViewSpec<D> spec) {
            spec.eye = moved(spec.eye);
            spec.look_at = moved(spec.look_at);
            return spec;
        });
    }

    void jitter(std::uint64_t seed) {
        Settings settings = lab_.settings;
        settings.seed = seed;
        compare(Disturbance::jitter, 0, *lab_.scene, settings, {}, [](ViewSpec<D> spec) { return spec; });
    }

    static double extent(const Primitive<2>& p) { return glm::dot(p[1] - p[0], p[1] - p[0]); }
    static double extent(const Primitive<3>& p) {
        const Vec<3> n = glm::cross(p[1] - p[0], p[2] - p[0]);
        return glm::dot(n, n);
    }
    /// A unit vector out of the primitive's plane, on its seen side.
    static Vec<2> out_of(const Primitive<2>& p) {
        const Vec<2> d = p[1] - p[0];
        return Vec<2>(-d.y, d.x) / std::sqrt(glm::dot(d, d));
    }
    static Vec<3> out_of(const Primitive<3>& p) {
        const Vec<3> n = glm::cross(p[1] - p[0], p[2] - p[0]);
        return n / std::sqrt(glm::dot(n, n));
    }

    /// From a point in the plane of the largest primitive that the first frame sees, along it: v · n is about 0 for
    /// every facet that the wall cuts.
    void graze() {
        const Set& visible = base_.front().visible;
        const auto& primitives = lab_.scene->primitives;
        std::optional<std::size_t> wall;
        for (std::size_t i = 0; i < primitives.size(); ++i)
            if (visible[i] && (!wall || extent(primitives[i]) > extent(primitives[*wall]))) wall = i;
        if (!wall) return;
        const Primitive<D>& p = primitives[*wall];
        const Vec<D> out = out_of(p);
        Vec<D> middle{};
        for (const Vec<D>& corner : p) middle += corner / static_cast<double>(D);
        const Vec<D> away = p[0] - middle;
        // The eye turns about the middle of the wall, at one and a half times the distance of its corner.
        std::vector<Outcome> before;
        Set visible_before;
        for (int i = -graze_steps; i <= graze_steps; ++i) {
            const SinCos angle = sincos_degrees(0.1 * i);
            const double distance = 1.5 * std::sqrt(glm::dot(away, away));
            ViewSpec<D> spec = lab_.specs.front();
            spec.eye =
                middle + away / std::sqrt(glm::dot(away, away)) * (distance * angle.cos) + out * (distance * angle.sin);
            spec.look_at = middle;
            const View<D> view = scene_view(spec, *lab_.scene, lab_.settings.reference_size);
            const Set now_visible = visible_set(*lab_.scene, view, lab_.settings.reference_size, draw_ids_);
            std::vector<Outcome> now = outcomes(*lab_.scene, lab_.cells, lab_.settings, view, now_visible);
            if (!before.empty()) add(Disturbance::grazing, 0.1, before, now, jaccard(visible_before, now_visible));
            before = std::move(now);
            visible_before = now_visible;
        }
    }

    std::vector<StabilityRow> rows() {
        std::vector<StabilityRow> all;
        for (auto& [key, sum] : sums_) {
            const auto& [m, disturbance, amount] = key;
            StabilityRow row = sum.row;
            row.scene = lab_.name;
            row.path = lab_.path;
            row.method = methods_[m].method;
            row.budget = budget_text(methods_[m].budget);
            row.disturbance = disturbance;
            row.amount = amount;
            const auto n = static_cast<double>(sum.coverages.size());
            const double mean = std::accumulate(sum.coverages.begin(), sum.coverages.end(), 0.0) / n;
            double squares = 0;
            for (const double c : sum.coverages) squares += (c - mean) * (c - mean);
            row.coverage_spread = std::sqrt(squares / n);
            if (disturbance == Disturbance::grazing) row.sweep = sum.coverages;
            all.push_back(std::move(row));
        }
        return all;
    }

    static constexpr int graze_steps = 10;
    const LabScene<D>& lab_;
    StabilityOptions options_;
    DrawIds draw_ids_;
    Random random_;
    double size_ = 1;
    std::vector<Choice> methods_;
    std::vector<Base> base_;  ///< per frame
    std::map<std::tuple<std::size_t, Disturbance, double>, Sum> sums_;
};

}  // namespace

std::string amount_text(double amount) {
    int exponent = 0;
    const bool is_power = std::frexp(amount, &exponent) == 0.5;
    return is_power && std::abs(exponent - 1) > 4 ? "2^" + std::to_string(exponent - 1) : number_text(amount);
}

template <int D>
std::vector<StabilityRow> measure_stability(const LabScene<D>& lab, const Study& study, const StabilityOptions& options,
                                            const DrawIds& draw_ids, const StabilityWatch& watch) {
    return StabilityStudy<D>(lab, study, options, draw_ids).run(watch);
}

template std::vector<StabilityRow> measure_stability<2>(const LabScene<2>&, const Study&, const StabilityOptions&,
                                                        const DrawIds&, const StabilityWatch&);
template std::vector<StabilityRow> measure_stability<3>(const LabScene<3>&, const Study&, const StabilityOptions&,
                                                        const DrawIds&, const StabilityWatch&);

}  // namespace sightline::lab
