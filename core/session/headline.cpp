// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/headline.h"

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/measure/metrics.h"

namespace sightline {

namespace {

template <int D>
constexpr const char* primitive_word = D == 2 ? "segment" : "triangle";

/// A frame of a flight does not wait for the reference.
template <int D>
bool knows_truth(const Session<D>& session) {
    return tells_truth(session) && (!session.flying() || session.has_reference());
}

}  // namespace

template <int D>
std::string headline(const Session<D>& session) {
    const Scene<D>& scene = session.scene();
    std::string text = scene.title.empty() ? scene.id : scene.title;
    text += ": " + std::string(session.method().title);
    if (session.method().orders_cells()) text += ", " + counted(session.cells().cell_count(), "cell");
    text += ", ";
    const std::string all = counted(scene.primitives.size(), primitive_word<D>);
    if (!knows_truth(session)) return text + all;
    return text + std::to_string(session.reference().count) + " of " + all + " visible";
}

std::string coverage_text(std::optional<double> coverage) {
    return coverage ? short_number(*coverage, separating_digits(*coverage, 1)) : "none";
}

template <int D>
std::string result_line(const Session<D>& session) {
    std::string text = std::to_string(session.counters().drawn()) + " drawn";
    if (!knows_truth(session)) return text;
    const std::uint32_t found = session.visible_rendered(), all = session.reference().count;
    if (all == 0) return text + ", nothing is visible";
    if (found == all) return text + ", all " + std::to_string(all) + " visible found";
    const auto share = coverage(session.reference(), found);
    return text + ", " + std::to_string(found) + " of " + std::to_string(all) + " visible found, coverage " +
           coverage_text(share);
}

std::string step_line(const StepExplanation& step, bool truth, std::string_view of) {
    std::string text = of.empty() ? "Step " : std::string(of) + ", step ";
    text += std::to_string(step.step);
    if (step.cell != none) {
        text += " took cell " + std::to_string(step.cell) + " (" + short_number(step.key, step.digits) + "). ";
        if (step.runner_up == none)
            text += "It was alone in the front.";
        else if (step.runner_up_key == step.key)
            text += "Cell " + std::to_string(step.runner_up) + " has the same key, and came later.";
        else
            text += "Next was " + std::to_string(step.runner_up) + " (" +
                    short_number(step.runner_up_key, step.digits) + ").";
        text += " ";
    } else {
        text += step.words.empty() ? ": " : ": " + step.words;
        // What became of it: "node 17, covered: postponed".
        if (!step.looked_at.empty() && step.item && step.looked_at.front().item == step.item)
            text += ", " + std::string(step.looked_at.front().words);
        if (!step.words.empty()) text += "; ";
    }
    text += std::to_string(step.rendered) + " drawn";
    if (!truth || step.rendered == 0) return text + ".";
    const bool all = step.visible == step.rendered;
    return text + ", " + (all ? "all" : step.visible == 0 ? "none" : std::to_string(step.visible)) + " visible.";
}

template std::string headline<2>(const Session<2>&);
template std::string headline<3>(const Session<3>&);
template std::string result_line<2>(const Session<2>&);
template std::string result_line<3>(const Session<3>&);

}  // namespace sightline
