// The figures of Coorg and Teller (1996), tables 1 to 4.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

namespace sightline::lab {

/// One of the paper's models; milliseconds on a machine of 1996.
struct PapersScene {
    const char *ours, *theirs;
    int polygons, references, construction_ms, first_frame_ms;
    struct Test {
        double tested_each, visible_ms, culled;
    };
    double occluders_ms;
    Test single, connected;
    std::array<double, 5> speeds;    ///< 1, 2, 4, 8 and 16 times walking
    std::array<double, 3> workers;   ///< 1, 2 and 4 processors
    std::array<double, 3> speedups;  ///< as printed
};

/// nullptr for a scene that stands for none of the paper's.
const PapersScene* papers_scene(const std::string& name);

}  // namespace sightline::lab
