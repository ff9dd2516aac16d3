// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/time_budget.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/base/stopwatch.h"
#include "core/run/drawn_levels.h"
#include "core/run/drive.h"
#include "core/truth/truth.h"

namespace sightline::lab {

namespace {

constexpr double slack = 1.1;  ///< of the budget

/// The frames of the path in order; costs are learned from the first one on.
void fly(const LabScene<3>& lab, const Variant<3>& variant, Tessellation cells, const Budget& budget,
         const Instruments& instruments, OwnRun<3>& run, TimedFlight& flight) {
    DrawnFrames drawn;
    std::vector<std::uint32_t> ids;
    std::shared_ptr<const FrameHistory> history;
    for (std::size_t i = 0; i < lab.views.size(); ++i) {
        Problem<3> problem = make_problem(variant.method, variant.parameters, *lab.scene, lab.on(cells), lab.views[i],
                                          none, known_services({}, lab.settings.reference_size));
        problem.history = history;
        const Stopwatch frame;
        run.start(problem, variant.method.start);
        drive(budget, *run, predict_cost(drawn, budget.value), frame);
        const double traversed = frame.milliseconds();
        drawn_ids(*run, ids);
        const DrawTimes times = instruments.time_drawing(drawn_scene(*run, lab.scene), lab.views[i], ids);
        const double total = frame.milliseconds();
        const auto rendered = static_cast<std::uint32_t>(ids.size());
        note_frame(drawn, rendered, total - traversed);
        flight.frames.push_back({rendered, traversed, times.upload, times.draw, total});
        if (variant.method.needs.history) history = run->next_history();
    }
}

}  // namespace

std::vector<TimedFlight> fly_in_time(const LabScene<3>& lab, const Study& study, const Instruments& instruments,
                                     const std::function<bool()>& go_on) {
    std::vector<TimedFlight> flights;
    if (!instruments.time_drawing) return flights;
    for (const MethodChoice& choice : study.methods) {
        const Method<3>* const method = method_of<3>(lab.tables, choice);
        if (!method || !method->budgeted || method->needs.visible_set) continue;
        const Variant<3> variant = lab.variant_for(choice);
        OwnRun<3> run;
        for (const Budget& budget : study.budgets) {
            if (budget.kind != Budget::Kind::milliseconds) continue;
            TimedFlight flight{lab.name, lab.path, choice, budget_text(budget), budget.value, {}};
            for (std::uint32_t repeat = 0; repeat <= study.repeats; ++repeat) {
                if (!go_on()) return flights;
                if (repeat == 1) flight.frames.clear();
                fly(lab, variant, choice.tessellation, budget, instruments, run, flight);
            }
            flights.push_back(std::move(flight));
        }
    }
    return flights;
}

std::string flights_json(const std::vector<TimedFlight>& flights) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const TimedFlight& flight : flights) {
        nlohmann::ordered_json one{
            {"scene", flight.scene},           {"path", flight.path},
            {"method", flight.method.variant}, {"tessellation", tessellation_word(flight.method)},
            {"budget_text", flight.budget},    {"budget_ms", flight.budget_ms}};
        for (const char* const name : {"rendered", "traverse_ms", "upload_ms", "draw_ms", "total_ms"})
            one[name] = nlohmann::ordered_json::array();
        for (const TimedFrame& frame : flight.frames) {
            one["rendered"].push_back(frame.rendered);
            one["traverse_ms"].push_back(frame.traverse_ms);
            one["upload_ms"].push_back(frame.upload_ms);
            one["draw_ms"].push_back(frame.draw_ms);
            one["total_ms"].push_back(frame.total_ms);
        }
        all.push_back(std::move(one));
    }
    return all.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::vector<TimedFlight> read_flights(std::string_view text) {
    std::vector<TimedFlight> flights;
    for (const auto& one : nlohmann::ordered_json::parse(text)) {
        TimedFlight flight{one.at("scene"),
                           one.at("path"),
                           {one.at("method"), read_tessellation(one.at("tessellation").get<std::string>())},
                           one.at("budget_text"),
                           one.at("budget_ms"),
                           {}};
        for (std::size_t i = 0; i < one.at("rendered").size(); ++i)
            flight.frames.push_back({one.at("rendered").at(i), one.at("traverse_ms").at(i), one.at("upload_ms").at(i),
                                     one.at("draw_ms").at(i), one.at("total_ms").at(i)});
        flights.push_back(std::move(flight));
    }
    return flights;
}

double share_kept(const TimedFlight& flight) {
    if (flight.frames.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto kept = std::count_if(flight.frames.begin(), flight.frames.end(), [&](const TimedFrame& frame) {
        return frame.total_ms <= slack * flight.budget_ms;
    });
    return static_cast<double>(kept) / static_cast<double>(flight.frames.size());
}

double longest_ms(const TimedFlight& flight) {
    double longest = flight.frames.empty() ? std::numeric_limits<double>::quiet_NaN() : 0;
    for (const TimedFrame& frame : flight.frames) longest = std::max(longest, frame.total_ms);
    return longest;
}

}  // namespace sightline::lab
