// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/claims.h"

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "lab/report/claim_table.h"

namespace sightline::lab {

namespace {

/// "city" of "city:100k".
std::string family(const std::string& scene) { return scene.substr(0, scene.find(':')); }

/// Whether two regimes disagree for which `differ` holds.
bool disagree(const std::vector<Regime>& regimes, const std::function<bool(const Regime&, const Regime&)>& differ) {
    for (const Regime& a : regimes)
        for (const Regime& b : regimes)
            if (a.holds && !b.holds && differ(a, b)) return true;
    return false;
}

/// Some regimes of the family hold, or some do not.
std::set<bool> outcomes_in(const std::vector<Regime>& regimes, const std::string& of) {
    std::set<bool> found;
    for (const Regime& regime : regimes)
        if (family(regime.scene) == of) found.insert(regime.holds);
    return found;
}

/// What explains that regimes disagree, one thing at a time where that is enough.
std::vector<std::string> causes(const std::vector<Regime>& regimes) {
    const auto same_path = [](const Regime& a, const Regime& b) { return a.path == b.path; };
    const auto same_size = [](const Regime& a, const Regime& b) { return a.scene == b.scene; };
    const auto same_family = [](const Regime& a, const Regime& b) { return family(a.scene) == family(b.scene); };
    bool path = disagree(regimes, [&](const auto& a, const auto& b) { return same_size(a, b) && !same_path(a, b); });
    bool size = disagree(regimes, [&](const auto& a, const auto& b) {
        return same_family(a, b) && !same_size(a, b) && same_path(a, b);
    });
    const bool scene = disagree(regimes, [&](const auto& a, const auto& b) {
        return outcomes_in(regimes, family(a.scene)).size() == 1 && outcomes_in(regimes, family(b.scene)).size() == 1;
    });
    if (!path && !size && !scene) {
        // Only pairs that differ in several things disagree.
        path = disagree(regimes, [&](const auto& a, const auto& b) { return same_family(a, b) && !same_path(a, b); });
        size = disagree(regimes, [&](const auto& a, const auto& b) { return same_family(a, b) && !same_size(a, b); });
    }
    std::vector<std::string> found;
    if (path) found.push_back("on path");
    if (size) found.push_back("on size");
    if (scene) found.push_back("on scene");
    return found;
}

}  // namespace

const char* papers_name(const std::string& scene) {
    static constexpr std::array<std::array<const char*, 2>, 7> names{{{"city", "CITY"},
                                                                      {"cars", "5CBEM"},
                                                                      {"room", "ROOM"},
                                                                      {"plant", "PLANT"},
                                                                      {"soda", "SODA"},
                                                                      {"blocks", "CITY OF BOXES"},
                                                                      {"tetra", "TETRA"}}};
    for (const auto& [ours, theirs] : names)
        if (family(scene) == ours) return theirs;
    return nullptr;
}

std::vector<Claim> judge_claims(const Results& results) {
    std::vector<Claim> claims;
    const std::vector<Group> all = groups(results);
    for (const ClaimRow& row : claim_table()) {
        Claim claim{row.source, row.text, row.test, {}};
        for (const Group& group : all) {
            const char* theirs = papers_name(group.scene);
            if (!theirs || std::find(row.scenes.begin(), row.scenes.end(), theirs) == row.scenes.end()) continue;
            if (part_of_path(group.path).has_value() != (row.frames == Frames::neighbours)) continue;
            if (std::optional<Regime> regime = row.judge({group, all})) {
                regime->scene = group.scene;
                regime->path = group.path;
                claim.regimes.push_back(std::move(*regime));
            }
        }
        if (!claim.regimes.empty()) claims.push_back(std::move(claim));
    }
    return claims;
}

Judgement judgement(const Claim& claim) {
    const auto holding =
        std::count_if(claim.regimes.begin(), claim.regimes.end(), [](const Regime& r) { return r.holds; });
    if (holding == 0) return Judgement::fails;
    return static_cast<std::size_t>(holding) == claim.regimes.size() ? Judgement::holds : Judgement::depends;
}

std::string verdict_text(const Claim& claim) {
    switch (judgement(claim)) {
        case Judgement::holds:
            return "holds";
        case Judgement::fails:
            return "does not hold";
        case Judgement::depends:
            break;
    }
    std::string text;
    for (const std::string& cause : causes(claim.regimes)) text += (text.empty() ? "" : ", ") + cause;
    return "depends (" + text + ")";
}

std::string regime_text(const Claim& claim, const Regime& regime) {
    std::string text = regime.scene + ", " + regime.path + ": " + regime.figures;
    if (judgement(claim) == Judgement::depends) text += regime.holds ? " (holds)" : " (does not hold)";
    return text;
}

const Row* row_to_show(const Claim& claim) {
    for (const Regime& regime : claim.regimes)
        if (!regime.holds && regime.row) return regime.row;
    return nullptr;
}

std::string claims_json(const std::vector<Claim>& claims) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Claim& claim : claims) {
        nlohmann::ordered_json one{{"source", claim.source},
                                   {"text", claim.text},
                                   {"test", claim.test},
                                   {"verdict", verdict_text(claim)},
                                   {"regimes", nlohmann::ordered_json::array()}};
        for (const Regime& regime : claim.regimes)
            one["regimes"].push_back(
                {{"scene", regime.scene}, {"path", regime.path}, {"figures", regime.figures}, {"holds", regime.holds}});
        all.push_back(std::move(one));
    }
    return all.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace sightline::lab
