// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/by_viewpoint/viewpoint_parameters.h"

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/methods/levels/levels_parameters.h"
#include "core/run/method.h"

namespace sightline {

namespace {

constexpr CullTime guessed{300, 20};
constexpr std::string_view times_form = "TECHNIQUE STEP/PRIMITIVE; …";

std::string check_techniques(const ParameterRow&, std::string_view text) {
    std::string all;
    for (const std::string& variant : split_variants(text)) {
        const std::string one = read_variant(variant).text();
        if (one.starts_with("by-viewpoint")) throw InputError("a choice cannot choose itself: leave by-viewpoint out");
        all += (all.empty() ? "" : "; ") + one;
    }
    if (all.empty()) throw InputError("no technique given");
    return all;
}

struct ListedTime {
    std::string variant;
    CullTime time;
};

/// Throws InputError.
std::vector<ListedTime> listed_times(std::string_view text) {
    std::vector<ListedTime> all;
    for (const std::string& part : split_variants(text)) {
        const std::size_t space = part.rfind(' '), slash = part.rfind('/');
        std::optional<double> step, met;
        if (space != std::string::npos && slash != std::string::npos && slash > space) {
            step = parse_number(part.substr(space + 1, slash - space - 1));
            met = parse_number(part.substr(slash + 1));
        }
        if (!step || !met || !(*step >= 0) || !(*met >= 0))
            throw InputError("'" + excerpt(text) + "' is no list of times: write " + std::string(times_form) +
                             " in nanoseconds, such as view 40/8");
        all.push_back({read_variant(part.substr(0, space)).text(), {*step, *met}});
    }
    return all;
}

std::string check_times(const ParameterRow&, std::string_view text) {
    if (split_variants(text).empty()) throw InputError("'' is no list of times: write " + std::string(times_form));
    std::string all;
    for (const ListedTime& listed : listed_times(text))
        all += (all.empty() ? "" : "; ") + cull_time_text(listed.variant, listed.time);
    return all;
}

std::string check_table(const ParameterRow&, std::string_view text) {
    if (!text.empty()) check_file(text);
    return std::string(text);
}

}  // namespace

const ParameterRow& techniques_row() {
    static const ParameterRow row = text_row(
        "techniques", "view; shadow-frusta; hom; boxes; portals", "methods or variants, by semicolons", "DAS table 1",
        "what can be chosen, as far as it suits the scene; the first is done where nothing else pays",
        check_techniques);
    return row;
}

const ParameterRow& choice_rule_row() {
    static const ParameterRow row = choice_row(
        "choose_by", ChoiceRule::least, "DAS 3.1.2",
        "what is cheapest by the cost model, or the paper's rule: rooms, few large occluders, many small ones");
    return row;
}

const ParameterRow& grid_row() {
    static const ParameterRow row =
        whole_row("grid", "0", 0, 64, "[0, 64]", "DAS 4", "boxes of eyes along each axis; 0: 8 in 2D, 4 in 3D");
    return row;
}

const ParameterRow& azimuths_row() {
    static const ParameterRow row =
        whole_row("azimuths", "8", 3, 64, "[3, 64]", "DAS fig. 1", "intervals of directions round the horizon");
    return row;
}

const ParameterRow& elevations_row() {
    static const ParameterRow row = whole_row("elevations", "3", 1, 31, "[1, 31]", "DAS fig. 1",
                                              "bands of directions between the caps around both poles; 3D only");
    return row;
}

const ParameterRow& samples_row() {
    static const ParameterRow row = whole_row("samples", "4", 1, 1000, "[1, 1000]", "DAS 3.1",
                                              "views at random places of a region that an entry looks at");
    return row;
}

const ParameterRow& allotted_ms_row() {
    static const ParameterRow row = number_row("allotted_ms", "16", 0, 1e6, "[0, 1e6]", "DAS 3.1.2",
                                               "milliseconds that a frame may take: below them the paper's rule does "
                                               "nothing more");
    return row;
}

const ParameterRow& few_row() {
    static const ParameterRow row =
        whole_row("few", "32", 1, 1e4, "[1, 1e4]", "DAS 3.1.2", "so many occluders are few enough for shadow frusta");
    return row;
}

const ParameterRow& few_cover_row() {
    static const ParameterRow row = number_row("few_cover", "0.4", 0, 1, "[0, 1]", "DAS 3.1.2",
                                               "the share of the view that occluders must cover to be worth it");
    return row;
}

const ParameterRow& switch_ms_row() {
    static const ParameterRow row = number_row("switch_ms", "0.5", 0, 1e6, "[0, 1e6]", "DAS 3",
                                               "what it takes to change from one technique to another (t_select)");
    return row;
}

const ParameterRow& valid_frames_row() {
    static const ParameterRow row = whole_row("valid_frames", "8", 1, 1e6, "[1, 1e6]", "DAS 3",
                                              "frames for which a choice is expected to hold (valid_frames)");
    return row;
}

const ParameterRow& cull_times_row() {
    static const ParameterRow row = text_row(
        "cull_times", "view 300/7; shadow-frusta 200/40; hom 0/400; boxes 300/300; levels 150/16; portals 3500/50",
        times_form, "docs/methods.md",
        "nanoseconds that techniques take a step and a primitive that they meet; lab viewpoint fits them", check_times);
    return row;
}

const ParameterRow& table_file_row() {
    static const ParameterRow row =
        text_row("table", "", "a file", "DAS 3.1",
                 "what was worked out beforehand; what it lacks is worked out when asked", check_table);
    return row;
}

std::vector<const ParameterRow*> viewpoint_parameter_rows() {
    return {&techniques_row(), &choice_rule_row(), &grid_row(),         &azimuths_row(),
            &elevations_row(), &samples_row(),     &allotted_ms_row(),  &few_row(),
            &few_cover_row(),  &switch_ms_row(),   &valid_frames_row(), &vertex_ns_row(),
            &pixel_ns_row(),   &cost_row(),        &cull_times_row(),   &table_file_row()};
}

CullTime cull_time(std::string_view times, std::string_view variant) {
    const std::vector<ListedTime> all = listed_times(times);
    const std::string id = read_variant(variant).id;
    const CullTime* of_method = nullptr;
    for (const ListedTime& listed : all) {
        if (listed.variant == variant) return listed.time;
        if (listed.variant == id) of_method = &listed.time;
    }
    return of_method ? *of_method : guessed;
}

std::string cull_time_text(std::string_view variant, const CullTime& time) {
    return std::string(variant) + " " + number_text(time.step_ns) + "/" + number_text(time.met_ns);
}

}  // namespace sightline
