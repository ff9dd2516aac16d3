// What the 3D pictures of tests/draw/picture_3d_test.cpp are: hashes of their lists as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace sightline::test {

using Goldens = std::vector<std::array<const char*, 6>>;

inline const Goldens picture_3d_goldens{
    {"55f7a98fc1ebec8d", "096bc162111d58ae", "fab9384e0b23e8ec", "fc1971cc74f83599", "e29c237ee269fdd2",
     "6b204e1e6e25e760"},
    {"4345baac659996ad", "131997982fff6b56", "f9ff6abe5ba9e563", "d580b9d73dd44692", "e27359fb53ddf5f9",
     "bfda124836ff1bbe"},
    {"4d55699f5a9a9103", "e23542b8c2bfc331", "0de220dc4de12e4f", "866826df0f27c471", "4e359cb2007e90f3",
     "b36e49719253fcea"},
    {"6db0ae79c8a72bf4", "1f375cf236415f49", "d0903179d7f33e57", "7cd2a2b80b0b1134", "cfa984fe9e4115cf",
     "9fc89ca00a529e6e"},
};

}  // namespace sightline::test
