// Which technique an entry of the table chooses, from what its views cost: plain numbers in, a decision and its reasons
// out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/methods/by_viewpoint/viewpoint_parameters.h"
#include "core/run/explanation.h"

namespace sightline {

/// What a technique costs an entry's views, predicted; means. Floats, since files keep many.
struct OptionCost {
    float cull_ms = 0, draw_ms = 0;
    float drawn = 0;  ///< primitives
    double ms() const { return double{cull_ms} + double{draw_ms}; }
    bool operator==(const OptionCost&) const = default;
};

/// Why an entry chose as it did.
enum class ChoiceReason : std::uint8_t {
    least,       ///< the cheapest by the cost model
    fits,        ///< what is in view fits the frame
    interior,    ///< the eyes are in a room
    few_large,   ///< few occluders cover enough of the view
    many_small,  ///< many do
    open,        ///< not even all occluders do
    no_gain,     ///< a technique was found, and costs more than it saves
};
inline constexpr auto choice_reason_words =
    std::to_array<std::string_view>({"least", "fits", "interior", "few-large", "many-small", "open", "no-gain"});

/// What is known of a region and an interval of directions before the choice.
struct EntryFacts {
    std::vector<OptionCost> costs;          ///< of each technique
    bool interior = false;                  ///< a room
    float few_cover = 0, all_cover = 0;     ///< shares of the view that the largest few occluders cover, and all
    std::uint32_t occluders = 0;            ///< large enough ones; the mean
    std::vector<std::uint32_t> candidates;  ///< ascending: a primitive of each of the largest ones; kept where chosen
    bool operator==(const EntryFacts&) const = default;
};

struct Entry {
    EntryFacts facts;
    std::uint32_t chosen = 0;  ///< index of a technique
    ChoiceReason reason = ChoiceReason::least;
    bool operator==(const Entry&) const = default;
};

/// The numbers of the rules.
struct ChoiceSettings {
    ChoiceRule rule = ChoiceRule::least;
    double frame_ms = 16, few_cover = 0.4, switch_ms = 0.5;
    std::uint32_t few = 32, valid_frames = 8;
};
ChoiceSettings choice_settings(const Parameters& parameters);

/// Indices of the techniques that the paper's rule names; none: not among those that can be chosen.
struct RuleTechniques {
    std::uint32_t portals = none, shadow_frusta = none, occlusion_maps = none;
};
/// By the ids of the methods.
RuleTechniques rule_techniques(std::span<const std::string> variants);

/// The first technique of least cost, or what the paper's rule says (DAS 3.1.2; the numbers that it leaves open are
/// settings): nothing more where what is in view fits the frame; portals in a room; shadow frusta where few occluders
/// cover enough of the view, occlusion maps where many do; and each only where culling saves more than it costs. The
/// occluders stay where a technique is chosen that has a use for them.
Entry choose(EntryFacts facts, const ChoiceSettings& settings, const RuleTechniques& by_rule);

/// Whether to change from the technique of the frame before: t_select / valid_frames + t(chosen) < t(before), with the
/// predicted times of this entry (DAS 3). True where there is no frame before.
bool pays_to_switch(const Entry& entry, std::uint32_t before, const ChoiceSettings& settings);

/// One sentence a decision, in their order, with the cost after each: "41 ms > 16 ms in view".
std::vector<Decision> decisions(const Entry& entry, const ChoiceSettings& settings,
                                std::span<const std::string> titles);

}  // namespace sightline
