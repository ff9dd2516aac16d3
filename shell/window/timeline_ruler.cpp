// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/timeline_ruler.h"

#include <algorithm>

#include "core/base/number.h"

namespace sightline {

namespace {

bool shown(const StepAxis& axis, float x) { return x >= axis.x - 0.5f && x <= axis.x + axis.w + 0.5f; }

/// "1 %" and "2 %" are "1, 2 %".
std::string joined(const std::string& a, const std::string& b) { return a.substr(0, a.find(" %")) + ", " + b; }

void place_label(const StepAxis& axis, const std::function<float(const std::string&)>& width, RulerLabel& label) {
    label.w = width(label.text);
    label.left = std::clamp(label.at - label.w / 2, axis.x, std::max(axis.x, axis.x + axis.w - label.w));
}

bool collide(const RulerLabel& a, const RulerLabel& b, float gap) {
    return a.left < b.left + b.w + gap && b.left < a.left + a.w + gap;
}

}  // namespace

std::vector<RulerLabel> ruler_labels(const StepAxis& axis, const std::function<float(const std::string&)>& width,
                                     float gap) {
    std::vector<RulerLabel> labels;
    const auto add = [&](RulerLabel label) {
        place_label(axis, width, label);
        const auto hits = [&](const RulerLabel& other) { return collide(label, other, gap); };
        if (shown(axis, label.at) && std::none_of(labels.begin(), labels.end(), hits))
            labels.push_back(std::move(label));
    };
    const auto last = static_cast<std::uint32_t>(axis.ends.size() - 1);
    add({RulerLabel::Kind::end, "end " + std::to_string(axis.ends[last]), x_of_step(axis, last)});
    const float widest = width(std::to_string(static_cast<std::uint64_t>(axis.to)));
    for (const double value : nice_values(axis, widest + 2 * gap))
        add({RulerLabel::Kind::number, std::to_string(static_cast<std::uint64_t>(value)), x_of_value(axis, value)});
    return labels;
}

std::vector<RulerLabel> budget_labels(const StepAxis& axis, const std::vector<BudgetTick>& budgets,
                                      const std::function<float(const std::string&)>& width, float gap) {
    std::vector<RulerLabel> labels;
    for (const BudgetTick& budget : budgets) {
        RulerLabel label{RulerLabel::Kind::number, budget.label, x_of_step(axis, budget.step)};
        if (!shown(axis, label.at)) continue;
        place_label(axis, width, label);
        while (!labels.empty() && collide(labels.back(), label, gap)) {
            label.text = joined(labels.back().text, label.text);
            label.at = labels.back().at;
            place_label(axis, width, label);
            labels.pop_back();
        }
        labels.push_back(label);
    }
    return labels;
}

}  // namespace sightline
