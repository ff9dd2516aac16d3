// What the 3D pictures of tests/draw/picture_3d_test.cpp are: hashes of their lists as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace sightline::test {

using Goldens = std::vector<std::array<const char*, 6>>;

inline const Goldens picture_3d_goldens{
    {"6d1688a40f702d0f", "fc5a6f7d3c704504", "859ea15dec5e176a", "13243365a74dcfb2", "d20e1cd20c181108", "495773fd4a2084d6"},
    {"40b209f6e366d192", "779c3131cea35b58", "9e52e0d36045ef8a", "f47509da2db655fc", "44b814f136d9bb5d", "3e6acabb500993c6"},
    {"180f9636a19a287a", "90e796348cc29940", "fab4745de890d348", "609353a017039364", "29c813a9e684fd62", "9d94a476c361fd48"},
    {"fb96d5d9200c72da", "05a5230a831ef9c2", "af2c4204bd697fea", "21063cb2c84cfa14", "7050226eacb72e0c", "35e538bca3553d0e"},
};

}  // namespace sightline::test
