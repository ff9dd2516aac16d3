// Labels of a draw list in the window: where they stand, and the text with halo, disc and leader.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/draw/label_pass.h"
#include "shell/window/ui.h"

namespace sightline {

/// A label that is shown.
struct LabelSpot {
    std::size_t label = 0;  ///< index among the labels
    Area box;               ///< of text, halo and disc
    ImVec2 text{};          ///< the text's upper left corner
    ImVec2 anchor{};        ///< what it speaks of
    bool leader = false;    ///< to the anchor
    float radius = 0;       ///< of the disc behind it; 0 without one
};

/// How labels are put down.
struct LabelPaper {
    Area area;                                       ///< labels whose point lies outside are left out, others moved in
    float pt = 4.0f / 3;                             ///< ImGui units to the point
    float halo = 2;                                  ///< width around the glyphs, ImGui units
    bool keep_apart = false;                         ///< LabelGround::keep_apart
    std::function<ImVec2(const Vec<2>&)> to_window;  ///< of Label::at
    std::function<ImVec2(const std::string&)> measure;
};

/// As stand_labels says, each at its own size.
std::vector<LabelSpot> place_labels(std::span<const Label> labels, const LabelPaper& paper, std::span<const Area> taken,
                                    LabelMemory& memory);

/// Draws them with the label font.
void draw_labels(ImDrawList& list, const Ui& ui, std::span<const Label> labels, std::span<const LabelSpot> spots);

/// Sizes in the label font.
LabelPaper label_paper(const Ui& ui, const Area& area, std::function<ImVec2(const Vec<2>&)> to_window);

}  // namespace sightline
