// One file for a tessellation and the primitives of its cells: the papers' offline mode (TVCG section 4).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/space/cell_complex.h"

namespace sightline {

/// Writes cells that build_cells(scene, settings) made; the file appears when it is complete. Throws WorkError.
template <int D>
void write_cells(const CellComplex<D>& cells, const Scene<D>& scene, const TessellationSettings& settings,
                 const std::filesystem::path& path);

/// What write_cells() wrote. Throws InputError, which names the file, when it is no such file, of another version or
/// dimension, truncated or damaged, of another scene, or made with other settings of the tessellation. Whatever the
/// file holds, the indices of the result are in range and its links agree with each other.
template <int D>
CellComplex<D> read_cells(const std::filesystem::path& path, const Scene<D>& scene,
                          const TessellationSettings& settings);

}  // namespace sightline
