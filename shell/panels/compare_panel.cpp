// Two sessions beside each other: what is different between them, and what comes of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number.h"
#include "core/session/headline.h"
#include "shell/desk/compare.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

/// In place of a number that a method does not have.
const std::string undefined = "–";
/// In place of one that would tell what is visible (tells_truth).
const std::string concealed = "?";

template <int D>
std::string coverage_cell(const Session<D>& session) {
    if (!tells_truth(session)) return concealed;
    if (session.flying() && !session.has_reference()) return "…";  // a frame of a flight does not wait for it
    const auto share = coverage(session.reference(), session.visible_rendered());
    return share ? coverage_text(share) : undefined;
}

/// A method without a front has none to compare with what it took.
template <int D>
std::string inversions_text(const Session<D>& session) {
    if (!tells_truth(session)) return concealed;
    return goes_through_cells(session) ? std::to_string(session.inversions().size()) : undefined;
}

}  // namespace

template <int D>
std::vector<Row> compare_rows(const Workbench<D>& bench) {
    if (!bench.other)
        return {Row{"Nothing to compare with: menu Compare, or type compare and a method, FIELD=VALUE or a file",
                    Tone::faint}};
    const Session<D>&left = bench.session, &right = bench.other->session;
    const auto titles = side_titles(bench);
    std::vector<Row> rows{{titles[0] + " | " + titles[1], Tone::heading, "swap"}};
    rows.back().tip = "click to swap left and right";
    const auto add = [&](const char* what, const std::string& a, const std::string& b, const char* command = "") {
        rows.push_back({std::string(what) + ": " + a + " | " + b, Tone::plain, command});
    };
    add("method", left.settings().method, right.settings().method);
    for (const SettingPair& pair : different_settings(left.settings(), right.settings()))
        if (pair.name != "method")
            rows.push_back({std::string(pair.name) + ": " + pair.left + " | " + pair.right, Tone::lit});
    if (left.shared_scene() != right.shared_scene()) add("scene", left.scene().id, right.scene().id);
    if (left.culling_view() != right.culling_view()) rows.push_back({"the culling views differ", Tone::lit});
    const bool flying = left.flying();
    const bool by_step = bench.other->align == Align::step;
    if (!flying)
        add("step", std::to_string(left.position()) + " of " + std::to_string(left.recorded()),
            std::to_string(right.position()) + " of " + std::to_string(right.recorded()), by_step ? "" : "align step");
    add("rendered", std::to_string(left.counters().drawn()), std::to_string(right.counters().drawn()),
        by_step ? "align rendered" : "");
    if (!flying) rows.push_back({align_sentence(left, right, bench.other->align), Tone::faint});
    add("coverage", coverage_cell(left), coverage_cell(right));
    if (!flying) add("inversions", inversions_text(left), inversions_text(right), "show inversions");
    if (!goes_through_cells(left) || !goes_through_cells(right))
        rows.push_back({"one goes through no cells: compare what is drawn", Tone::faint});
    else if (!same_cells(left, right))
        rows.push_back({"the cells differ: cell numbers cannot be compared", Tone::faint});
    if (flying) {
        rows.push_back({"flying: frames are not recorded, so their order cannot be compared", Tone::faint});
    } else {
        const Difference& difference = first_difference(bench);
        rows.push_back({difference.sentence, difference.step == none ? Tone::good : Tone::lit,
                        difference.step == none ? "" : "difference"});
    }
    rows.push_back({"stop comparing", Tone::faint, "compare off"});
    return rows;
}

template std::vector<Row> compare_rows<2>(const Workbench<2>&);
template std::vector<Row> compare_rows<3>(const Workbench<3>&);

}  // namespace sightline
