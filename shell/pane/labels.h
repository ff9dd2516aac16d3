// Labels of a draw list in the window: where they stand, and the text with halo, disc and leader.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <functional>
#include <span>
#include <vector>

#include "shell/window/ui.h"

namespace sightline {

/// A label that is shown.
struct LabelSpot {
    std::size_t label = 0;  ///< index among the labels
    Area box;               ///< of text, halo and disc
    ImVec2 text{};          ///< the text's upper left corner
    ImVec2 anchor{};        ///< what it speaks of
    float radius = 0;       ///< of the disc behind it; 0 without one
};

/// How labels are put down.
struct LabelPaper {
    Area area;                                       ///< labels whose point lies outside are left out, others moved in
    float pt = 4.0f / 3;                             ///< ImGui units to the point
    float halo = 2;                                  ///< width around the glyphs, ImGui units
    std::function<ImVec2(const Vec<2>&)> to_window;  ///< of Label::at
    std::function<ImVec2(const std::string&)> measure;
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

/// Labels that do not yield take their places first, then those in `memory`, then the others in their order; one that
/// yields moves within its room, and is left out where it would still lie on a taken place or on one of `taken`. About
/// linear in the labels.
std::vector<LabelSpot> place_labels(std::span<const Label> labels, const LabelPaper& paper, std::span<const Area> taken,
                                    LabelMemory& memory);

/// Draws them with the label font.
void draw_labels(ImDrawList& list, const Ui& ui, std::span<const Label> labels, std::span<const LabelSpot> spots);

/// Sizes in the label font.
LabelPaper label_paper(const Ui& ui, const Area& area, std::function<ImVec2(const Vec<2>&)> to_window);

}  // namespace sightline
