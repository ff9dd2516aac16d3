// What the 3D pictures of tests/draw/picture_3d_test.cpp are: hashes of their lists as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace sightline::test {

using Goldens = std::vector<std::array<const char*, 6>>;

inline const Goldens picture_3d_goldens{
    {"3608b7ff043d0374", "096bc162111d58ae", "ca092bdc87f1bf6e", "fc1971cc74f83599", "56bc0c95731984bf",
     "6b204e1e6e25e760"},
    {"dbdd5350b0198f85", "131997982fff6b56", "a072f419b4295dc5", "d580b9d73dd44692", "5cfe495b213e709c",
     "bfda124836ff1bbe"},
    {"5235933bac01e937", "e23542b8c2bfc331", "931ddbe04345ebf7", "866826df0f27c471", "353c03c00c964822",
     "b36e49719253fcea"},
    {"1a48845930c7fd4a", "1f375cf236415f49", "4ba3098e188f64f6", "7cd2a2b80b0b1134", "355da625f3e5a294",
     "9fc89ca00a529e6e"},
};

}  // namespace sightline::test
