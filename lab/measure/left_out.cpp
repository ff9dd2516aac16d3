// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/left_out.h"

#include <algorithm>
#include <set>

#include "core/base/excerpt.h"
#include "lab/measure/wrong_budget.h"

namespace sightline::lab {

namespace {

/// What the method's row says, the same in both dimensions.
struct Asked {
    const MethodChoice& choice;
    bool budgeted, follows_wrong_pixels;
};

template <int D>
void add_asked(const Study& study, std::vector<Asked>& all) {
    for (const MethodChoice& choice : study.methods)
        if (const Method<D>* const method = method_of<D>(study.tables, choice))
            all.push_back(
                {choice, method->budgeted && !method->needs.visible_set, can_follow_wrong_pixels<D>(*method)});
}

}  // namespace

std::vector<std::string> left_out(const Study& study, bool times_drawing) {
    std::vector<std::string> lines;
    std::vector<Asked> all;
    has_3d(study) ? add_asked<3>(study, all) : add_asked<2>(study, all);
    const bool budgeted = std::any_of(all.begin(), all.end(), [](const Asked& one) { return one.budgeted; });
    const bool in_time = std::any_of(study.budgets.begin(), study.budgets.end(),
                                     [](const Budget& b) { return b.kind == Budget::Kind::milliseconds; });
    std::set<std::string> scenes;
    for (const SceneOnPath& one : scenes_on_paths(study)) scenes.insert(one.scene);
    for (const std::string& scene : scenes)
        if (const bool in_2d = parse_scene(scene).dimension == 2; in_time && budgeted && (in_2d || !times_drawing))
            lines.push_back(excerpt(scene) + ": no method is measured with a budget in time: " +
                            (in_2d ? "in 2D no drawing is timed" : "without OpenGL no drawing is timed"));
    if (!study.wrong_budgets.empty())
        for (const Asked& one : all)
            if (one.budgeted && !one.follows_wrong_pixels)
                lines.push_back(excerpt(method_text(one.choice)) +
                                ": is not measured with a budget in wrong pixels: its order depends on the budget or "
                                "on the frames before");
    return lines;
}

}  // namespace sightline::lab
