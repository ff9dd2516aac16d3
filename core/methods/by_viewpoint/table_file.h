// A table by viewpoint as a file: what was worked out is not worked out again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/methods/by_viewpoint/viewpoint_table.h"

namespace sightline {

/// JSON: {"format": "sightline-viewpoints", "version": 1, …}: what the entries depend on, and those that are known.
/// The file appears when it is complete. Throws WorkError.
template <int D>
void write_table(const ViewpointTable<D>& table, const std::filesystem::path& path);

/// Puts the file's entries into the table. Throws InputError that names the file when it is none of these, damaged, of
/// another scene, or worked out with other parameters.
template <int D>
void read_table(const ViewpointTable<D>& table, const std::filesystem::path& path);

}  // namespace sightline
