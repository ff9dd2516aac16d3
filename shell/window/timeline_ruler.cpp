// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/timeline_ruler.h"

#include <algorithm>

#include "core/base/number.h"

namespace sightline {

namespace {

bool shown(const StepAxis& axis, float x) { return x >= axis.x - 0.5f && x <= axis.x + axis.w + 0.5f; }

/// "1 %" and "2 %" are "1, 2 %".
std::string joined(const std::string& a, const std::string& b) { return a.substr(0, a.find(" %")) + ", " + b; }

}  // namespace

std::vector<RulerLabel> ruler_labels(const StepAxis& axis, const std::vector<BudgetTick>& budgets,
                                     const std::function<float(const std::string&)>& width, float gap) {
    std::vector<RulerLabel> labels;
    const auto place = [&](RulerLabel& label) {
        label.w = width(label.text);
        label.left = std::clamp(label.at - label.w / 2, axis.x, std::max(axis.x, axis.x + axis.w - label.w));
    };
    const auto collides = [&](const RulerLabel& a, const RulerLabel& b) {
        return a.left < b.left + b.w + gap && b.left < a.left + a.w + gap;
    };
    const auto add = [&](RulerLabel label) {
        place(label);
        if (!shown(axis, label.at)) return;
        if (std::none_of(labels.begin(), labels.end(), [&](const RulerLabel& other) { return collides(label, other); }))
            labels.push_back(std::move(label));
    };
    const auto last = static_cast<std::uint32_t>(axis.ends.size() - 1);
    add({RulerLabel::Kind::end, "end " + std::to_string(axis.ends[last]), x_of_step(axis, last)});

    std::vector<RulerLabel> shares;
    for (const BudgetTick& budget : budgets) {
        RulerLabel label{RulerLabel::Kind::budget, budget.label, x_of_step(axis, budget.step)};
        if (!shown(axis, label.at)) continue;
        place(label);
        while (!shares.empty() && collides(shares.back(), label)) {
            label.text = joined(shares.back().text, label.text);
            label.at = shares.back().at;
            place(label);
            shares.pop_back();
        }
        shares.push_back(label);
    }
    for (const RulerLabel& label : shares) add(label);

    const float widest = width(std::to_string(static_cast<std::uint64_t>(axis.to)));
    for (const double value : nice_values(axis, widest + 2 * gap))
        add({RulerLabel::Kind::number, std::to_string(static_cast<std::uint64_t>(value)), x_of_value(axis, value)});
    return labels;
}

}  // namespace sightline
