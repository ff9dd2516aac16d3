// A session as a file, or two beside each other: scene, settings, view, step, notes. A figure's sidecar is one; opening
// it shows the same again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/session/comparison.h"
#include "core/session/figure_spec.h"
#include "core/session/session.h"

namespace sightline {

/// A 2D scene whose JSON is at most this long travels inside the state file; a larger one by id, seed and hash, unless
/// it was edited: then it lies nowhere else.
inline constexpr std::size_t embed_limit_bytes = 1'000'000;

/// Which scenes travel inside.
enum class Carry : std::uint8_t {
    small_ones,              ///< see embed_limit_bytes
    what_no_generator_makes  ///< files of any size; generated ones by id, seed and hash
};

/// `other`: a session that stands beside the first one, moved along as `align` says.
template <int D>
std::string state_json(const Session<D>& session, const FigureSpec& figure = {}, const Session<D>* other = nullptr,
                       Align align = Align::step, Carry carry = Carry::small_ones);

template <int D>
struct OpenedState {
    Session<D> session;
    FigureSpec figure;
    std::vector<std::string> warnings;  ///< e.g. that the traversal has changed since
    std::optional<Session<D>> other{};  ///< shares the scene of `session` when it had the same
    Align align = Align::step;
    bool of_another_scene = false;  ///< than it was made with
};

/// `name` begins every error line. The scene is looked for as it is written, then beside the file `name`, then among
/// the files there of the same ending, by its hash. `scene`: another one in its place, by any name that load_scene
/// takes; where it has another hash, what refers to steps, cells and primitives is left out with a warning. Throws
/// InputError when the text is no state file, when the scene it names cannot be found or is another one (by hash),
/// when a setting does not exist, when it is of the other dimension, or when a breakpoint is no condition.
template <int D = 2>
OpenedState<D> open_state(std::string_view text, const std::string& name,
                          std::span<const Method<D>> methods = method_table<D>(), const DrawIds& draw_ids = {},
                          const Progress& progress = {}, const std::string& scene = "");

}  // namespace sightline
