// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/image_space/image_parameters.h"

namespace sightline {

const ParameterRow& occluders_row() {
    static const ParameterRow row =
        choice_row("occluders", Occluders::own, "TVCG 7, TR 6",
                   "drawn before the first box is tested: the method's own, none, what was visible in the last frame, "
                   "the largest, or what PLP renders");
    return row;
}

const ParameterRow& occluder_share_row() {
    static const ParameterRow row =
        number_row("occluder_share", "0.01", 0, 1, "[0, 1]", "TVCG 7",
                   "how many of the largest occluders, or of PLP's, as a share of the primitives");
    return row;
}

const ParameterRow& refresh_row() {
    static const ParameterRow row =
        whole_row("refresh", "256", 1, 1e6, "[1, 1e6]", "docs/methods.md",
                  "boxes between two refreshes of the depths that boxes are tested against");
    return row;
}

const ParameterRow& worth_row() {
    static const ParameterRow row =
        number_row("worth", "0", 0, 1e6, "[0, 1e6]", "docs/methods.md",
                   "with less than one primitive in view for so many pixels nothing is tested, as drawing all is "
                   "cheaper; 0: always test");
    return row;
}

const ParameterRow& opacity_row() {
    static const ParameterRow row =
        number_row("opacity", "1", 0, 1, "[0, 1]", "Zhang et al. 1997, section 4",
                   "the covered share of a block of pixels from which on it counts as covered; below 1 small gaps are "
                   "overlooked");
    return row;
}

}  // namespace sightline
