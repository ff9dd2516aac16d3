// What the 3D pictures of tests/draw/picture_3d_test.cpp are: hashes of their lists as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace sightline::test {

using Goldens = std::vector<std::array<const char*, 6>>;

inline const Goldens picture_3d_goldens{
    {"69bb8ce7a76361c6", "64ce5bf306cdf36c", "ef51d2f4b8e8c1e2", "d7e36d55f5f781d9", "e37fd0c6db0c161d",
     "2dc1497b5aff3a91"},
    {"4e65bb5032bfcc5d", "cd2c2518ab8aa942", "1833dbc762955a57", "983e08bbc9bc4d67", "96cc74b633942d4a",
     "f7ab330d577ebc59"},
    {"edc1af6354a59721", "e7162fcddeda3160", "f81882d90dc8f424", "c984eced9f3696d5", "3f6420d4252e4a85",
     "3d4787e1e91e6e0a"},
    {"ab7fafc81e503023", "d936053031664365", "c37c30a21dd0a090", "deac729234c98c2a", "e2514e0ab96a3c5e",
     "035f528aa95c4ca6"},
};

}  // namespace sightline::test
