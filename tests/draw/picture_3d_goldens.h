// What the 3D pictures of tests/draw/picture_3d_test.cpp are: hashes of their lists as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace sightline::test {

using Goldens = std::vector<std::array<const char*, 6>>;

inline const Goldens picture_3d_goldens{
    {"891bdea332b9fab3", "6ccfc050f2ab912a", "d8d269ecc5f72eb5", "a9b80f3fa4013a92", "6a8172a74325e01a",
     "e715dad17103b2e8"},
    {"5c35003f5f189014", "d7772c05cea9e12a", "7f06ee513fd64125", "59bd23e970d70bcf", "60f117204cfd7e5c",
     "3780ead92be3ed0c"},
    {"0339fc769e40848a", "3878422fd94d800d", "e76acd758b43ceab", "db3fa7e8a178210d", "3e33267097ae7be2",
     "8654701cd911c499"},
    {"571aa1b8951e5c20", "e5c8377c08f00040", "631994ef94f34a7d", "0feebe868db36c2c", "2d9359dd01adab99",
     "fd08087d25afa6f0"},
};

}  // namespace sightline::test
