// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/object_space/papers_scenes.h"

namespace sightline::lab {

const PapersScene* papers_scene(const std::string& name) {
    static constexpr std::array<PapersScene, 3> table{{{"soda",
                                                        "Soda",
                                                        1685,
                                                        2971,
                                                        160,
                                                        510,
                                                        4.7,
                                                        {40, 20, 0.73},
                                                        {38, 18, 0.75},
                                                        {17, 23, 30, 43, 61},
                                                        {17, 13, 8},
                                                        {1, 1.3, 2.13}},
                                                       {"blocks",
                                                        "City",
                                                        2857,
                                                        4722,
                                                        270,
                                                        480,
                                                        4.5,
                                                        {36, 23, 0.35},
                                                        {34, 22, 0.38},
                                                        {20, 28, 41, 55, 76},
                                                        {20, 14, 9},
                                                        {1, 1.43, 2.22}},
                                                       {"tetra",
                                                        "Tetra",
                                                        3601,
                                                        4974,
                                                        260,
                                                        740,
                                                        4.6,
                                                        {57, 32, 0.69},
                                                        {56, 32, 0.69},
                                                        {26, 40, 59, 86, 112},
                                                        {26, 18, 11},
                                                        {1, 1.55, 2.36}}}};
    const std::string id = name.substr(0, name.find(':'));
    for (const PapersScene& scene : table)
        if (id == scene.ours) return &scene;
    return nullptr;
}

}  // namespace sightline::lab
