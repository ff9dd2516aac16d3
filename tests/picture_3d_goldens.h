// What the 3D pictures of tests/picture_3d_test.cpp are: hashes of their lists as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace sightline::test {

using Goldens = std::vector<std::array<const char*, 6>>;

inline const Goldens picture_3d_goldens{
    {"7ee4498dc6c27ae4", "9936d66d87adb8f8", "8e4f69b44799d45c", "1c64e3d8f9876bed", "4333f8bcdee7fc57",
     "5c9c1784ffc72f61"},
    {"68f40397d0c9f117", "bab038786cde77c0", "2b84c935e8f3000e", "bc8c652d3d65c79d", "d2a20033a8f95d49",
     "656e0b1d3bdfbe8e"},
    {"e59b8c6d50b8e349", "b4a5ca7965e40fba", "9c570eb2778cb24e", "b27be4fed1cc1b44", "81fe9d2d342d4f08",
     "e6a5a708b8262341"},
    {"b6af65220cbe8611", "2e2290f72491d009", "e57c7334a5010cc8", "078928acda684bff", "4481c0099e4a9aaf",
     "f9066e5f0afa8171"},
};

}  // namespace sightline::test
