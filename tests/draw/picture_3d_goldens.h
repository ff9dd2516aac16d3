// What the 3D pictures of tests/draw/picture_3d_test.cpp are: hashes of their lists as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace sightline::test {

using Goldens = std::vector<std::array<const char*, 6>>;

inline const Goldens picture_3d_goldens{
    {"64bde7493bd033fe", "9936d66d87adb8f8", "5bc6e08d9fdd2798", "1c64e3d8f9876bed", "4333f8bcdee7fc57",
     "5c9c1784ffc72f61"},
    {"362e5a2f236d76cc", "bab038786cde77c0", "bfe5e30fa41c92fa", "bc8c652d3d65c79d", "d2a20033a8f95d49",
     "656e0b1d3bdfbe8e"},
    {"a1a8517c8d08e480", "b4a5ca7965e40fba", "9183510cd4879a64", "b27be4fed1cc1b44", "81fe9d2d342d4f08",
     "e6a5a708b8262341"},
    {"d6e06d778e490a05", "2e2290f72491d009", "d752ee921afadc9d", "078928acda684bff", "4481c0099e4a9aaf",
     "f9066e5f0afa8171"},
};

}  // namespace sightline::test
