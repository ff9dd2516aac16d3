// One pass that gives every text over a picture its place, in the window and on a figure's page. y down, any unit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/draw/label_place.h"

namespace sightline {

/// What labels are put on.
struct LabelGround {
    Box<2> frame;           ///< labels stay inside; those whose point lies outside, by more than `slack`, are left out
    double slack = 0;       ///< of rounding
    double pt = 1;          ///< units to the point
    double least_room = 0;  ///< a label with less room about its point stays there
    std::function<Vec<2>(const Vec<2>&)> to_paper;  ///< of Label::at
    /// How large a label is in its form k, where it has one: 0 is as it is meant, others take other room (narrower, in
    /// more lines).
    std::function<std::optional<LabelSize>(const Label&, std::size_t k)> size;
    /// Labels that must show stand where they want, whatever is there; else they too keep off all else, move as far as
    /// they must and have a leader to what they speak of.
    bool keep_apart = false;
};

/// A label that is shown.
struct StandingLabel {
    std::size_t label = 0;  ///< index among the labels
    std::size_t form = 0;
    Vec<2> anchor{};      ///< what it speaks of
    Vec<2> tip{};         ///< of the leader: the anchor, or the border of another label that lies over it
    Box<2> box;           ///< of text, halo and disc
    bool leader = false;  ///< from the box to the tip
};

/// The point of a label that was shown, and which of its places it had.
struct ShownLabel {
    double x = 0, y = 0;
    std::size_t shift = 0;
    auto operator<=>(const ShownLabel&) const = default;
};

/// The labels that were shown last, sorted. They keep their places before others take one, so that while stepping
/// numbers change but do not move, come or go.
using LabelMemory = std::vector<ShownLabel>;

/// Labels that do not yield take their places first: those that are fixed, discs, the rest. Then those in `memory`,
/// which is brought up to date, then the others in their order. One that yields moves within its room, and is left out
/// where it would still lie on a taken place or on one of `taken`. With keep_apart no two boxes overlap, nor a box and
/// a leader; what finds no place at all, or is fixed to one that is taken, is left out. About linear in the labels.
std::vector<StandingLabel> stand_labels(std::span<const Label> labels, const LabelGround& ground,
                                        std::span<const Box<2>> taken, LabelMemory* memory = nullptr);

}  // namespace sightline
