// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/viewpoint/calibrate.h"

#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/run/drawn_levels.h"

namespace sightline::lab {

namespace {

/// x and y at least 0 for which x·a + y·b comes closest to c; a, b, c by sample.
std::array<double, 2> fit_two(const std::vector<std::array<double, 3>>& rows) {
    double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
    for (const auto& [a, b, c] : rows) {
        aa += a * a;
        ab += a * b;
        bb += b * b;
        ac += a * c;
        bc += b * c;
    }
    const double determinant = aa * bb - ab * ab;
    if (determinant > 1e-12 * aa * bb) {
        const double x = (ac * bb - bc * ab) / determinant, y = (bc * aa - ac * ab) / determinant;
        if (x >= 0 && y >= 0) return {x, y};
    }
    // One of the two alone: the one that leaves less.
    const double x = aa > 0 ? std::max(0.0, ac / aa) : 0, y = bb > 0 ? std::max(0.0, bc / bb) : 0;
    return x * ac >= y * bc ? std::array{x, 0.0} : std::array{0.0, y};
}

/// Both kinds of work of what is drawn, as the reading has it: all at once, or part by part.
std::vector<DrawnSize> parts_of(const CostSample& sample, CostReading reading) {
    if (reading == CostReading::sum_of_max) return sample.sizes;
    DrawnSize all;
    for (const DrawnSize& size : sample.sizes) {
        all.vertices += size.vertices;
        all.pixels += size.pixels;
    }
    return {all};
}

DrawingCost fit_drawing(const std::vector<CostSample>& samples, CostReading reading) {
    constexpr int most_turns = 50;
    // At first each alone explains all.
    double vertices = 0, pixels = 0, ms = 0;
    for (const CostSample& sample : samples) {
        for (const DrawnSize& size : sample.sizes) {
            vertices += static_cast<double>(size.vertices);
            pixels += static_cast<double>(size.pixels);
        }
        ms += sample.draw_ms;
    }
    DrawingCost cost{vertices > 0 ? 1e6 * ms / vertices : 0, pixels > 0 ? 1e6 * ms / pixels : 0};
    for (int turn = 0; turn < most_turns; ++turn) {
        std::vector<std::array<double, 3>> rows;
        for (const CostSample& sample : samples) {
            std::array<double, 3> row{0, 0, 1e6 * sample.draw_ms};
            for (const DrawnSize& part : parts_of(sample, reading)) {
                const double v = static_cast<double>(part.vertices), p = static_cast<double>(part.pixels);
                if (cost.vertex_ns * v >= cost.pixel_ns * p)
                    row[0] += v;
                else
                    row[1] += p;
            }
            rows.push_back(row);
        }
        const auto [vertex_ns, pixel_ns] = fit_two(rows);
        const DrawingCost next{vertex_ns, pixel_ns};
        if (next == cost) break;
        cost = next;
    }
    return cost;
}

}  // namespace

double Calibration::draw_ms(const CostSample& sample) const {
    FrameDrawing frame(cost);
    for (const DrawnSize& size : sample.sizes) frame.add(size);
    return frame.ms(reading);
}

double Calibration::ms(const CostSample& sample) const {
    return draw_ms(sample) + cull_times[sample.option].ms(sample.steps, sample.met);
}

double r_squared(const std::vector<double>& predicted, const std::vector<double>& measured) {
    double mean = 0, errors = 0, deviations = 0;
    for (const double value : measured) mean += value / static_cast<double>(measured.size());
    for (std::size_t i = 0; i < measured.size(); ++i) {
        errors += (measured[i] - predicted[i]) * (measured[i] - predicted[i]);
        deviations += (measured[i] - mean) * (measured[i] - mean);
    }
    return deviations > 0 ? 1 - errors / deviations : 0;
}

std::shared_ptr<const Scene<3>> one_scene(const ViewpointProblem<3>& problem,
                                          const std::shared_ptr<const Scene<3>>& scene) {
    for (const Variant<3>& option : problem.options)
        if (option.method.draws_levels) return scene_with_levels(*problem.cells, *problem.scene);
    return scene;
}

std::vector<CostSample> cost_samples(const ViewpointProblem<3>& problem, const std::vector<View<3>>& views,
                                     const std::shared_ptr<const Scene<3>>& scene, const TimeDrawing& time_drawing,
                                     int repeats, const std::function<bool(std::size_t)>& go_on) {
    std::vector<CostSample> samples;
    std::vector<OwnRun<3>> runs(problem.options.size());
    Analyst<3> analyst(problem);
    Services services;
    services.image = problem.image;
    const auto drawn = one_scene(problem, scene);
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < views.size(); ++i) {
        for (std::uint32_t option = 0; option < runs.size(); ++option) {
            const Variant<3>& variant = problem.options[option];
            CostSample sample;
            sample.option = option;
            std::vector<double> cull, draw;
            std::shared_ptr<const FrameHistory> history;
            for (int repeat = -1; repeat < repeats; ++repeat) {
                const Problem<3> one = make_problem(variant.method, variant.parameters, *problem.scene, *problem.cells,
                                                    views[i], none, services, history);
                const double cull_ms = run_milliseconds(variant.method, one, runs[option]);
                if (history == nullptr) history = runs[option]->next_history();
                drawn_ids(*runs[option], ids);
                const DrawTimes times = time_drawing(drawn, views[i], ids);

                const DrawTimes empty = time_drawing(drawn, views[i], {});
                if (repeat < 0) continue;  // to warm up
                cull.push_back(cull_ms);
                draw.push_back(times.upload + times.draw - empty.upload - empty.draw);
            }
            sample.steps = runs[option]->steps();
            sample.met = runs[option]->counters().touched_count;
            sample.sizes = analyst.drawn_sizes(*runs[option], views[i]);
            sample.cull_ms = median(cull);
            sample.draw_ms = std::max(0.0, median(draw));
            samples.push_back(std::move(sample));
        }
        if (!go_on(i + 1)) break;
    }
    return samples;
}

Calibration fit(const std::vector<CostSample>& samples, std::size_t options, CostReading reading) {
    Calibration fitted;
    fitted.reading = reading;
    fitted.cost = fit_drawing(samples, reading);
    for (std::uint32_t option = 0; option < options; ++option) {
        std::vector<std::array<double, 3>> rows;
        for (const CostSample& sample : samples)
            if (sample.option == option) rows.push_back({sample.steps, sample.met, 1e6 * sample.cull_ms});
        const auto [step_ns, met_ns] = fit_two(rows);
        fitted.cull_times.push_back({step_ns, met_ns});
    }
    std::vector<double> drawing, drawn, predicted, measured;
    for (const CostSample& sample : samples) {
        drawing.push_back(fitted.draw_ms(sample));
        drawn.push_back(sample.draw_ms);
        predicted.push_back(fitted.ms(sample));
        measured.push_back(sample.ms());
    }
    fitted.r2_draw = r_squared(drawing, drawn);
    fitted.r2 = r_squared(predicted, measured);
    return fitted;
}

std::string parameters_text(const Calibration& fitted, const std::vector<Variant<3>>& options) {
    const auto rounded = [](double value) { return *parse_number(short_number(value)); };
    std::string times;
    for (std::size_t i = 0; i < options.size(); ++i) {
        const CullTime time{rounded(fitted.cull_times[i].step_ns), rounded(fitted.cull_times[i].met_ns)};
        times += (i ? "; " : "") + cull_time_text(options[i].text, time);
    }
    return "vertex_ns=" + number_text(rounded(fitted.cost.vertex_ns)) +
           " pixel_ns=" + number_text(rounded(fitted.cost.pixel_ns)) + " cost=" + std::string(word(fitted.reading)) +
           " cull_times='" + times + "'";
}

}  // namespace sightline::lab
