// What the 3D pictures of tests/draw/picture_3d_test.cpp are: hashes of their lists as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace sightline::test {

using Goldens = std::vector<std::array<const char*, 6>>;

inline const Goldens picture_3d_goldens{
    {"69bb8ce7a76361c6", "6ccfc050f2ab912a", "ef51d2f4b8e8c1e2", "a9b80f3fa4013a92", "e37fd0c6db0c161d",
     "29b6c3d7d1e5ba80"},
    {"4e65bb5032bfcc5d", "d7772c05cea9e12a", "1833dbc762955a57", "59bd23e970d70bcf", "96cc74b633942d4a",
     "e178e1c0b021d9a4"},
    {"edc1af6354a59721", "3878422fd94d800d", "f81882d90dc8f424", "db3fa7e8a178210d", "3f6420d4252e4a85",
     "da20e1169ce53118"},
    {"ab7fafc81e503023", "e5c8377c08f00040", "c37c30a21dd0a090", "0feebe868db36c2c", "e2514e0ab96a3c5e",
     "0ffa6554b893bcd6"},
};

}  // namespace sightline::test
