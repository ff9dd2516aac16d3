// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/object_space_parameters.h"

namespace sightline {

const ParameterRow& connected_row() {
    static const ParameterRow row = choice_row(
        "connected", Connected::off, "CT 2.1",
        "occluders that hide a box together: none, all that meet at edges, those grown across the planes that the box "
        "crosses, or any, by the angles of their shadows (2D; in 3D as grow)");
    return row;
}

const ParameterRow& occluder_count_row() {
    static const ParameterRow row = whole_row("occluder_count", "32", 1, 1024, "[1, 1024]", "CT 3.3, CT 4",
                                              "k: how many of the potential occluders hide anything");
    return row;
}

const ParameterRow& shadow_count_row() {
    static const ParameterRow row = whole_row("shadows", "8", 1, 256, "[1, 256]", "Hudson et al. 1997, section 4",
                                              "how many shadows the boxes are tested against");
    return row;
}

const ParameterRow& threshold_row() {
    static const ParameterRow row = number_row("threshold", "0.01", 1e-6, 100, "[1e-06, 100]", "CT 3.3",
                                               "the least area-angle of an occluder: its area, as the eye sees it "
                                               "turned, over its squared distance (2D: length over distance)");
    return row;
}

const ParameterRow& tree_row() {
    static const ParameterRow row = choice_row("tree", TreeKind::kd, "CT 3, CT 4",
                                               "how space is cut: across one axis, or across all in the middle");
    return row;
}

const ParameterRow& leaf_row() {
    static const ParameterRow row =
        whole_row("leaf", "8", 1, 4096, "[1, 4096]", "CT 3",
                  "how many primitives a leaf of the tree may hold by their middles; those that reach into it are "
                  "noted in it too");
    return row;
}

const ParameterRow& leaves_row() {
    static const ParameterRow row =
        choice_row("leaves", Leaves::whole, "CT 2.1, CT 3",
                   "what is drawn of a leaf that is PARTIAL: all of it, or its polygons that no occluders hide");
    return row;
}

const ParameterRow& coherence_row() {
    static const ParameterRow row =
        choice_row("coherence", Coherence::on, "CT 3.1",
                   "keep what was found out about a box until the eye has come as far as the nearest plane that "
                   "decided it; saves time and changes nothing");
    return row;
}

const ParameterRow& step_is_row() {
    static const ParameterRow row =
        choice_row("step", StepIs::node, "CT 3.1",
                   "what a step is: a box, or all boxes up to the next one whose state is another than in the frame "
                   "before");
    return row;
}

const ParameterRow& workers_row() {
    static const ParameterRow row =
        whole_row("workers", "1", 0, 64, "[0, 64]", "CT 3.2",
                  "threads that share the tree, one subtree after the other; 0: as many as the machine has; changes "
                  "nothing else");
    return row;
}

}  // namespace sightline
