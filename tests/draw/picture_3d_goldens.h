// What the 3D pictures of tests/draw/picture_3d_test.cpp are: hashes of their lists as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace sightline::test {

using Goldens = std::vector<std::array<const char*, 6>>;

inline const Goldens picture_3d_goldens{
    {"69bb8ce7a76361c6", "5532d0df7e98983e", "e7731886870cce84", "67bdf8acbb356f63", "e37fd0c6db0c161d",
     "2dc1497b5aff3a91"},
    {"4e65bb5032bfcc5d", "6f1cf8e40c2e2d34", "7fdea05f3851ac45", "16e3f7fb28521cd0", "96cc74b633942d4a",
     "f7ab330d577ebc59"},
    {"edc1af6354a59721", "23c4aeb6c75fd06e", "5b1b011178156b3c", "a150634a83a5f469", "3f6420d4252e4a85",
     "3d4787e1e91e6e0a"},
    {"ab7fafc81e503023", "6b26f91fb9dc5d39", "fc34d97b1fa1840d", "0e617f17753d6734", "e2514e0ab96a3c5e",
     "035f528aa95c4ca6"},
};

}  // namespace sightline::test
