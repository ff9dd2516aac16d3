// What the 3D pictures of tests/draw/picture_3d_test.cpp are: hashes of their lists as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace sightline::test {

using Goldens = std::vector<std::array<const char*, 6>>;

inline const Goldens picture_3d_goldens{
    {"fcfb878637f4d46a", "bf13094d4efa35fd", "b27e6af4471071e7", "e3314581bef01e48", "a28e3b33ffe50b9a", "a006c66f73d3dede"},
    {"5a8d296f77ed7a6c", "fc84e5340559acd3", "32b22d0884e50ada", "c2e7d4a2dbc95ddd", "4fe150978ff32fe7", "0dbc28e919916830"},
    {"f0438cdf9cf72279", "b3f8e3139370812a", "d5ed8cdc7054f09b", "0eac16a835446d7d", "d93a1382200fb177", "bca85de72a0c7193"},
    {"aec42336c0c953b7", "ed0d6e8a2a74c263", "55286fb876dc334b", "a09611108d2d96de", "8d67163eae4a9e90", "d2c600113e501e60"},
};

}  // namespace sightline::test
