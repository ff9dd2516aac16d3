// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/wrong_budget.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/number.h"
#include "core/measure/frame_numbers.h"
#include "core/run/wrong_budget.h"
#include "core/truth/software_ids.h"
#include "core/truth/truth.h"

namespace sightline::lab {

namespace {

constexpr double slack_of_pixels = 1.1;  ///< of the share
constexpr std::string_view prefix = "wrong:";

}  // namespace

template <int D>
std::vector<WrongFlight> fly_in_wrong_pixels(const LabScene<D>& lab, const Study& study, const DrawIds& draw_ids,
                                             const std::function<bool()>& go_on) {
    struct Flying {
        Variant<D> variant;
        WrongFlight flight;
        NeededBudgets needed{};
    };
    std::vector<Flying> all;
    for (const MethodChoice& choice : study.methods) {
        const Method<D>* const method = method_of<D>(lab.tables, choice);
        if (!method || !can_follow_wrong_pixels<D>(*method)) continue;
        for (const double wrong : study.wrong_budgets)
            all.push_back({lab.variant_for(choice), {lab.name, lab.path, choice, wrong, {}}});
    }
    const auto total = static_cast<std::uint32_t>(lab.scene->primitives.size());
    for (std::size_t frame = 0; frame < lab.views.size() && !all.empty(); ++frame) {
        if (!go_on()) return {};
        // What is visible does not depend on the cells.
        const CellComplex<D>* const cells = &lab.on(all.front().flight.method.tessellation);
        const Truth truth =
            std::move(make_truths<D>(*lab.scene, {&cells, 1}, lab.views[frame], lab.settings.reference_size,
                                     drawing_of(lab.settings.reference, draw_ids), false)
                          .front());
        for (Flying& one : all) {
            const WholeRun run = whole_run<D>(one.variant.method,
                                              make_problem(one.variant.method, one.variant.parameters, *lab.scene,
                                                           lab.on(one.flight.method.tessellation), lab.views[frame],
                                                           none, known_services({}, lab.settings.reference_size)),
                                              truth.reference, false);
            const std::uint32_t budget = predict_needed(one.needed, total);
            const Cut cut = cut_at(run, budget);
            const auto met = std::span(run.met).first(cut.met);
            const auto rendered =
                std::count_if(met.begin(), met.end(), [](const Met entry) { return !entry.culled(); });
            one.flight.frames.push_back({budget, static_cast<std::uint32_t>(rendered),
                                         wrong_pixels(truth.reference, met),
                                         needed_budget(run, truth.reference, one.flight.wrong, total)});
            note_needed(one.needed, budget, needed_budget(run, truth.reference, one.flight.wrong, budget));
        }
    }
    std::vector<WrongFlight> flights;
    for (Flying& one : all) flights.push_back(std::move(one.flight));
    return flights;
}

template std::vector<WrongFlight> fly_in_wrong_pixels<2>(const LabScene<2>&, const Study&, const DrawIds&,
                                                         const std::function<bool()>&);
template std::vector<WrongFlight> fly_in_wrong_pixels<3>(const LabScene<3>&, const Study&, const DrawIds&,
                                                         const std::function<bool()>&);

std::string wrong_budget_text(double share) { return std::string(prefix) + short_number(100 * share) + "%"; }

std::optional<double> parse_wrong_budget(std::string_view text) {
    if (!text.starts_with(prefix)) return std::nullopt;
    const std::string_view digits = text.substr(prefix.size());
    const auto value = digits.ends_with('%') ? parse_number(digits.substr(0, digits.size() - 1)) : std::nullopt;
    if (!value || !(*value >= 0 && *value < 100))
        throw InputError("budget '" + excerpt(text) + "': write a share of the pixels, such as wrong:0.5%");
    return *value / 100;
}

double share_kept(const WrongFlight& flight) {
    if (flight.frames.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    const auto kept = std::count_if(flight.frames.begin() + 1, flight.frames.end(), [&](const WrongFrame& frame) {
        return frame.wrong <= slack_of_pixels * flight.wrong;
    });
    return static_cast<double>(kept) / static_cast<double>(flight.frames.size() - 1);
}

std::string kept_text(const WrongFlight& flight) {
    const std::size_t judged = std::max<std::size_t>(flight.frames.size(), 1) - 1;
    return (judged == 0 ? std::string("none") : short_number(100 * share_kept(flight)) + " %") + " of " +
           std::to_string(judged) + " frames (all but the first, which nothing is known of) within " +
           wrong_budget_text(flight.wrong) + " + 10 %";
}

std::string wrong_flights_json(const std::vector<WrongFlight>& flights) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const WrongFlight& flight : flights) {
        nlohmann::ordered_json one{{"scene", flight.scene},
                                   {"path", flight.path},
                                   {"method", flight.method.variant},
                                   {"tessellation", tessellation_word(flight.method)},
                                   {"wrong_budget", flight.wrong}};
        for (const char* const name : {"budget", "rendered", "wrong", "needed"})
            one[name] = nlohmann::ordered_json::array();
        for (const WrongFrame& frame : flight.frames) {
            one["budget"].push_back(frame.budget);
            one["rendered"].push_back(frame.rendered);
            one["wrong"].push_back(frame.wrong);
            one["needed"].push_back(frame.needed == none ? nlohmann::ordered_json()
                                                         : nlohmann::ordered_json(frame.needed));
        }
        all.push_back(std::move(one));
    }
    return all.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::vector<WrongFlight> read_wrong_flights(std::string_view text) {
    std::vector<WrongFlight> flights;
    for (const auto& one : nlohmann::ordered_json::parse(text)) {
        WrongFlight flight{one.at("scene"),
                           one.at("path"),
                           {one.at("method"), read_tessellation(one.at("tessellation").get<std::string>())},
                           one.at("wrong_budget"),
                           {}};
        for (std::size_t i = 0; i < one.at("rendered").size(); ++i) {
            const auto& needed = one.at("needed").at(i);
            flight.frames.push_back({one.at("budget").at(i), one.at("rendered").at(i), one.at("wrong").at(i),
                                     needed.is_null() ? none : needed.get<std::uint32_t>()});
        }
        flights.push_back(std::move(flight));
    }
    return flights;
}

}  // namespace sightline::lab
