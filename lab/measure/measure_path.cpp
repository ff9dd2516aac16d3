// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/measure_path.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/measure/distance.h"
#include "core/measure/frame_change.h"
#include "core/measure/frame_numbers.h"
#include "core/run/drawn_levels.h"
#include "core/session/settings_table.h"
#include "core/truth/software_ids.h"

namespace sightline::lab {

namespace {

/// Lines, and rays of all frames together, by which a tessellation is stabbed: the mean is good to about 2 %.
constexpr std::uint32_t stabbing_lines = 1000;

/// What a method drew at one budget in one frame, kept until the next.
struct DrawnFrame {
    std::vector<std::uint8_t> rendered, wrong;
};

/// A frame of one method at all budgets.
struct Shown {
    std::vector<DrawnFrame> at;  ///< per budget
    std::vector<Values> values;
    std::vector<std::shared_ptr<const FrameHistory>> histories;  ///< per budget
};

/// All methods in one frame.
struct FrameOfAll {
    Reference reference;  ///< on one of the tessellations
    std::vector<Shown> methods;
};

template <int D>
class PathStudy {
public:
    PathStudy(const LabScene<D>& lab, const Study& study, const Instruments& instruments)
        : lab_(lab), study_(study), instruments_(instruments) {
        const auto all = static_cast<std::uint32_t>(lab.scene->primitives.size());
        for (const MethodChoice& choice : study.methods) {
            if (!method_of<D>(lab.tables, choice)) continue;
            Choice c{lab.variant_for(choice), choice, {}, {}};
            if (!c.variant.method.budgeted)
                c.budgets.push_back({"unlimited", all});
            else
                for (const Budget& budget : study.budgets)
                    if (budget.kind != Budget::Kind::milliseconds)  // those are flown: time_budget.h
                        c.budgets.push_back({budget_text(budget), std::min(all, budget.primitives(all))});
            methods_.push_back(std::move(c));
        }
    }

    std::vector<Row> run() {
        if (methods_.empty()) return {};
        std::vector<Row> rows = empty_rows();
        FrameOfAll before;
        bool has_before = false;
        for (std::uint32_t i = 0; i < lab_.frames.size(); ++i) {
            FrameResult result{i, {}};
            if (auto finished = instruments_.finished ? instruments_.finished(i) : std::nullopt) {
                result = std::move(*finished);
                has_before = false;
            } else {
                if (i > 0 && !has_before) before = numbers(i - 1);
                FrameOfAll now = numbers(i);
                if (D == 3)
                    for (Row& row : rows) row.reference = now.reference.name;  // who drew it
                if (i > 0) compare(before, now);
                take_times(i, now);
                for (const Shown& shown : now.methods)
                    result.values.insert(result.values.end(), shown.values.begin(), shown.values.end());
                before = std::move(now);
                has_before = true;
            }
            for (std::size_t r = 0; r < rows.size(); ++r) {
                rows[r].frames.push_back(lab_.frames[i]);
                rows[r].values.push_back(result.values.at(r));
            }
            if (instruments_.frame_done && !instruments_.frame_done(result)) break;
        }
        return rows;
    }

private:
    struct AtBudget {
        std::string text;
        std::uint32_t primitives;
    };
    struct Choice {
        Variant<D> variant;
        MethodChoice choice;
        std::vector<AtBudget> budgets;
        OwnRun<D> timed;  ///< reused
    };

    /// Without a budget.
    Problem<D> problem_of(std::size_t method, std::uint32_t i, const Services& services) const {
        const Choice& c = methods_[method];
        return make_problem(c.variant.method, c.variant.parameters, *lab_.scene, lab_.on(c.choice.tessellation),
                            lab_.views[i], none, services);
    }
    /// What a run keeps of the frame before saves time in the next one: it has to see that frame before each repeat, or
    /// it would be asked for what it knows already.
    void show_frame_before(Choice& c, std::uint32_t i, Problem<D> problem) const {
        if (!c.variant.method.needs.last_frame) return;
        if (!lab_.before[i]) {
            c.timed = {};
            return;
        }
        problem.view = *lab_.before[i];
        c.timed.start(problem, c.variant.method.start);
        c.timed->run(none);
    }
    Services services_of(const FrameOfAll& frame) const {
        return known_services(std::make_shared<std::vector<std::uint8_t>>(frame.reference.visible),
                              lab_.settings.reference_size);
    }

    FrameOfAll numbers(std::uint32_t i) {
        std::vector<const CellComplex<D>*> tessellations;
        std::array<std::size_t, tessellation_count> truth_of{};
        for (std::size_t t = 0; t < tessellation_count; ++t)
            if (lab_.cells[t]) {
                truth_of[t] = tessellations.size();
                tessellations.push_back(&*lab_.cells[t]);
            }
        const std::vector<Truth> truths =
            make_truths<D>(*lab_.scene, tessellations, lab_.views[i], lab_.settings.reference_size,
                           drawing_of(lab_.settings.reference, instruments_.draw_ids));
        FrameOfAll frame;
        frame.reference = truths.front().reference;
        frame.methods.resize(methods_.size());
        const Services services = services_of(frame);
        const std::vector<std::uint8_t> distances =
            distance_bins_of<D>(frame.reference.image, *lab_.scene, lab_.views[i]);
        const DrawIds draw_ids = drawing_of(lab_.settings.reference, instruments_.draw_ids);
        const auto measure = [&](std::size_t m) {
            const Truth& truth = truths[truth_of[static_cast<std::size_t>(methods_[m].choice.tessellation)]];
            Problem<D> problem = problem_of(m, i, services);
            const Method<D>& method = methods_[m].variant.method;
            if (method.prefixes) problem.history = frame_history(method, problem, lab_.before[i]);
            WholeRun run;
            if (method.prefixes) run = whole_run<D>(method, problem, truth.reference, true, draw_ids);
            Shown& shown = frame.methods[m];
            for (const AtBudget& budget : methods_[m].budgets) {
                const std::uint32_t k = problem.budget = budget.primitives;
                if (!method.prefixes) problem.history = frame_history(method, problem, lab_.before[i]);
                shown.histories.push_back(problem.history);
                if (!method.prefixes) run = whole_run<D>(method, problem, truth.reference, true, draw_ids);
                const auto best = method.orders_cells() ? cell_oracle<D>(truth.reference, problem) : std::nullopt;
                DrawnFrame drawn;
                drawn.rendered = rendered_by(run, cut_at(run, k).met, lab_.scene->primitives.size());
                drawn.wrong = wrong_by(run, truth.reference.image, drawn.rendered);
                shown.values.push_back(frame_numbers(run, truth, k, drawn.rendered, drawn.wrong, best));
                count_distances(distances, drawn.wrong, shown.values.back());
                shown.at.push_back(std::move(drawn));
            }
        };
        tbb::parallel_for(std::size_t{0}, methods_.size(), [&](std::size_t m) {
            if (!methods_[m].variant.method.draws_levels) measure(m);
        });
        // Those draw images of what they show, and OpenGL is asked from one thread.
        for (std::size_t m = 0; m < methods_.size(); ++m)
            if (methods_[m].variant.method.draws_levels) measure(m);
        return frame;
    }

    static void compare(const FrameOfAll& before, FrameOfAll& now) {
        const double change = 1 - jaccard(before.reference.visible, now.reference.visible);
        for (std::size_t m = 0; m < now.methods.size(); ++m)
            for (std::size_t b = 0; b < now.methods[m].at.size(); ++b) {
                const DrawnFrame &a = before.methods[m].at[b], &c = now.methods[m].at[b];
                Values& values = now.methods[m].values[b];
                if (const auto share = pop(before.reference.visible, a.rendered, now.reference.visible, c.rendered))
                    values[Measure::pop] = *share;
                values[Measure::flip] = difference(a.wrong, c.wrong);
                values[Measure::visible_change] = change;
            }
    }

    void take_times(std::uint32_t i, FrameOfAll& now) {
        if (study_.repeats == 0) return;
        const Services services = services_of(now);
        std::vector<std::uint32_t> ids;
        for (std::size_t m = 0; m < methods_.size(); ++m) {
            Problem<D> problem = problem_of(m, i, services);
            for (std::size_t b = 0; b < methods_[m].budgets.size(); ++b) {
                problem.history = now.methods[m].histories[b];
                Choice& c = methods_[m];
                problem.budget = c.budgets[b].primitives;
                TimeSamples times;
                const bool pays = pays_for_traversal(c.variant.method);
                for (std::uint32_t repeat = 0; repeat <= (pays ? study_.repeats : 0); ++repeat) {
                    show_frame_before(c, i, problem);
                    const double ms = run_milliseconds<D>(c.variant.method, problem, c.timed);
                    if (repeat > 0) times.traverse.push_back(ms);
                }
                if constexpr (D == 3)
                    if (instruments_.time_drawing) time_drawing(i, *c.timed, ids, times);
                Values& values = now.methods[m].values[b];
                set_times(times, values);
                // Without OpenGL the total would leave the drawing out.
                if (D == 3 && !instruments_.time_drawing)
                    values[Measure::total_ms] = values[Measure::total_error] = std::numeric_limits<double>::quiet_NaN();
            }
        }
        compare_with_exact(now);
    }

    /// How many times the frame takes what drawing exactly V takes.
    void compare_with_exact(FrameOfAll& now) const {
        for (std::size_t m = 0; m < methods_.size(); ++m) {
            if (methods_[m].choice.variant != exactly_v) continue;
            const double exact = now.methods[m].values.front()[Measure::total_ms];
            for (Shown& shown : now.methods)
                for (Values& values : shown.values) values[Measure::over_exact] = values[Measure::total_ms] / exact;
        }
    }

    /// Draws what the run rendered, after once to warm up.
    void time_drawing(std::uint32_t i, const Run<3>& run, std::vector<std::uint32_t>& ids, TimeSamples& times) {
        drawn_ids(run, ids);
        const std::shared_ptr<const Scene<3>> scene = drawn_scene(run, lab_.scene);
        for (std::uint32_t repeat = 0; repeat <= study_.repeats; ++repeat) {
            const DrawTimes once = instruments_.time_drawing(scene, lab_.views[i], ids);
            if (repeat == 0) continue;
            times.upload.push_back(once.upload);
            times.draw.push_back(once.draw);
        }
    }

    CellNumbers cell_numbers(Tessellation kind) const {
        const CellComplex<D>& cells = lab_.on(kind);
        const auto views = std::max<std::size_t>(1, lab_.views.size());
        const auto rays = static_cast<std::uint32_t>((stabbing_lines + views - 1) / views);
        return {lab_.build_seconds[static_cast<std::size_t>(kind)],
                cells.memory_bytes(),
                cells.reference_memory_bytes(),
                lab_.scene->primitives.size() * sizeof(Primitive<D>),
                cells.cell_primitives.size(),
                random_lines<D>(cells, stabbing_lines),
                eye_rays<D>(cells, lab_.views, rays),
                density<D>(cells)};
    }

    std::vector<Row> empty_rows() const {
        std::vector<Row> rows;
        std::array<std::optional<CellNumbers>, tessellation_count> numbers;
        const std::string size = image_size_text(image_size<D>(lab_.settings.reference_size));
        for (std::size_t m = 0; m < methods_.size(); ++m)
            for (const AtBudget& budget : methods_[m].budgets) {
                const CellComplex<D>& cells = lab_.on(methods_[m].choice.tessellation);
                Row row;
                row.scene = lab_.name;
                row.path = lab_.path;
                row.method = methods_[m].choice;
                row.approximate =
                    methods_[m].variant.method.promise_with(methods_[m].variant.parameters) == Misses::may;
                row.budget = budget.text;
                row.error_bound = lab_.settings.error_bound;
                row.primitives = static_cast<std::uint32_t>(lab_.scene->primitives.size());
                row.cells = cells.cell_count();
                row.memory_bytes = cells.memory_bytes() + cells.reference_memory_bytes();
                auto& of_cells = numbers[static_cast<std::size_t>(methods_[m].choice.tessellation)];
                if (!of_cells) of_cells = cell_numbers(methods_[m].choice.tessellation);
                row.tessellation = *of_cells;
                row.reference = D == 2 ? "exact, item buffer " + size.substr(0, size.find('x')) : "item buffer " + size;
                rows.push_back(std::move(row));
            }
        return rows;
    }

    const LabScene<D>& lab_;
    const Study& study_;
    const Instruments& instruments_;
    std::vector<Choice> methods_;
};

}  // namespace

template <int D>
std::vector<Row> measure_path(const LabScene<D>& lab, const Study& study, const Instruments& instruments) {
    return PathStudy<D>(lab, study, instruments).run();
}

template std::vector<Row> measure_path<2>(const LabScene<2>&, const Study&, const Instruments&);
template std::vector<Row> measure_path<3>(const LabScene<3>&, const Study&, const Instruments&);

}  // namespace sightline::lab
