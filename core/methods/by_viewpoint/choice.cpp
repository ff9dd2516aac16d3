// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/by_viewpoint/choice.h"

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/run/method.h"

namespace sightline {

namespace {

std::string ms_text(double ms) { return short_number(ms) + " ms"; }
std::string percent(double share) { return short_number(100 * share) + " %"; }

std::string cost_sentence(const OptionCost& cost) {
    return ms_text(cost.ms()) + " = culling " + short_number(double{cost.cull_ms}) + " + drawing " +
           short_number(double{cost.draw_ms}) + " (" +
           counted(static_cast<std::size_t>(cost.drawn + 0.5f), "primitive") + ")";
}

/// The technique that the paper's rule names, whether or not it pays.
std::uint32_t named_by_rule(const EntryFacts& facts, const ChoiceSettings& settings, const RuleTechniques& by_rule,
                            ChoiceReason& reason) {
    if (facts.interior && by_rule.portals != none) {
        reason = ChoiceReason::interior;
        return by_rule.portals;
    }
    if (facts.few_cover >= settings.few_cover && by_rule.shadow_frusta != none) {
        reason = ChoiceReason::few_large;
        return by_rule.shadow_frusta;
    }
    if (facts.all_cover >= settings.few_cover && by_rule.occlusion_maps != none) {
        reason = ChoiceReason::many_small;
        return by_rule.occlusion_maps;
    }
    reason = ChoiceReason::open;
    return 0;
}

}  // namespace

ChoiceSettings choice_settings(const Parameters& parameters) {
    ChoiceSettings settings;
    settings.rule = parameters.choice<ChoiceRule>(choice_rule_row());
    settings.frame_ms = parameters.number(allotted_ms_row());
    settings.few_cover = parameters.number(few_cover_row());
    settings.switch_ms = parameters.number(switch_ms_row());
    settings.few = static_cast<std::uint32_t>(parameters.number(few_row()));
    settings.valid_frames = static_cast<std::uint32_t>(parameters.number(valid_frames_row()));
    return settings;
}

RuleTechniques rule_techniques(std::span<const std::string> variants) {
    RuleTechniques found;
    const auto first = [&](std::string_view id, std::uint32_t& index) {
        for (std::uint32_t i = 0; i < variants.size() && index == none; ++i)
            if (read_variant(variants[i]).id == id) index = i;
    };
    first("portals", found.portals);
    first("shadow-frusta", found.shadow_frusta);
    first("hom", found.occlusion_maps);
    return found;
}

Entry choose(EntryFacts facts, const ChoiceSettings& settings, const RuleTechniques& by_rule) {
    Entry entry{std::move(facts), 0, ChoiceReason::least};
    const std::vector<OptionCost>& costs = entry.facts.costs;
    if (settings.rule == ChoiceRule::least) {
        for (std::uint32_t i = 1; i < costs.size(); ++i)
            if (costs[i].ms() < costs[entry.chosen].ms()) entry.chosen = i;
    } else if (costs[0].ms() <= settings.frame_ms) {
        entry.reason = ChoiceReason::fits;
    } else {
        entry.chosen = named_by_rule(entry.facts, settings, by_rule, entry.reason);
        if (entry.chosen != 0 && !(costs[entry.chosen].ms() < costs[0].ms())) {
            entry.chosen = 0;
            entry.reason = ChoiceReason::no_gain;
        }
    }
    if (entry.chosen != by_rule.shadow_frusta && entry.chosen != by_rule.occlusion_maps) entry.facts.candidates.clear();
    return entry;
}

bool pays_to_switch(const Entry& entry, std::uint32_t before, const ChoiceSettings& settings) {
    const std::vector<OptionCost>& costs = entry.facts.costs;
    if (before >= costs.size()) return true;
    return settings.switch_ms / settings.valid_frames + costs[entry.chosen].ms() < costs[before].ms();
}

std::vector<Decision> decisions(const Entry& entry, const ChoiceSettings& settings,
                                std::span<const std::string> titles) {
    const EntryFacts& facts = entry.facts;
    const std::string& chosen = titles[entry.chosen];
    const double all_ms = facts.costs[0].ms(), after_ms = facts.costs[entry.chosen].ms();
    std::vector<Decision> list;
    if (settings.rule == ChoiceRule::least) {
        for (std::size_t i = 0; i < titles.size(); ++i)
            list.push_back({titles[i] + ": " + cost_sentence(facts.costs[i]), facts.costs[i].ms()});
        list.push_back({"least: " + chosen, after_ms});
        return list;
    }
    if (entry.reason == ChoiceReason::fits) {
        list.push_back(
            {"what is in view takes " + ms_text(all_ms) + " ≤ " + ms_text(settings.frame_ms) + ": nothing more to do",
             all_ms});
        return list;
    }
    list.push_back({"what is in view takes " + ms_text(all_ms) + " > " + ms_text(settings.frame_ms), all_ms});
    if (facts.interior) list.push_back({"the eye is in a room", all_ms});
    list.push_back({counted(facts.occluders, "occluder") + "; the largest " + std::to_string(settings.few) + " cover " +
                        percent(facts.few_cover) + " of the view, all " + percent(facts.all_cover) + "; " +
                        percent(settings.few_cover) + " are asked for",
                    all_ms});
    switch (entry.reason) {
        case ChoiceReason::open:
            list.push_back({"too little is covered: " + chosen, after_ms});
            break;
        case ChoiceReason::no_gain:
            list.push_back({"culling would cost more than it saves: " + chosen, after_ms});
            break;
        default:
            list.push_back({chosen + ": " + cost_sentence(facts.costs[entry.chosen]) +
                                (after_ms <= settings.frame_ms ? ": done" : ": still too long"),
                            after_ms});
    }
    return list;
}

}  // namespace sightline
