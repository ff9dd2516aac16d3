// The scene that a state file names, wherever it lies by now.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/scene/read/load.h"

namespace sightline {

/// The scene of that hash (hash_text of scene_hash): `file`, any name that load_scene takes, or a file beside the state
/// file `state`, by its name or, among those of the same ending, by its hash. Throws InputError.
template <int D>
Scene<D> find_state_scene(const std::string& file, const std::string& hash, const std::string& state,
                          const LoadOptions& options);

}  // namespace sightline
