// Hashes of the catalogue's scenes, cells and runs as lines of text; tests/files/golden_hashes.txt holds them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sightline::test {

/// A line each, "KEY: VALUE", in an order that stays: all scenes in both dimensions, their cells in both
/// tessellations, all methods on them, and some settings of the traversal on a few scenes.
std::vector<std::string> golden_hashes();

/// Lines of `wanted` that `held`, the text of the list, has otherwise or lacks, as they should stand; then the keys
/// that only `held` has, each behind "no longer: ". Empty lines and those that begin with # do not count.
std::vector<std::string> changed_lines(const std::string& held, const std::vector<std::string>& wanted);

}  // namespace sightline::test
