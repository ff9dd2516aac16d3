// A session as a file: scene, settings, view, step, notes. A figure's sidecar is one; opening it shows the same again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/session/figure_spec.h"
#include "core/session/session.h"

namespace sightline {

/// A scene whose JSON is at most this long travels inside the state file; a larger one by id, seed and hash.
inline constexpr std::size_t embed_limit_bytes = 1'000'000;

std::string state_json(const Session<2>& session, const FigureSpec& figure = {});

struct OpenedState {
    Session<2> session;
    FigureSpec figure;
    std::vector<std::string> warnings;  ///< e.g. that the traversal has changed since
};

/// `name` begins every error line. Throws InputError when the text is no state file, when the scene it names cannot be
/// found or is another one (by hash), or when a setting does not exist.
OpenedState open_state(std::string_view text, const std::string& name,
                       std::span<const Method<2>> methods = method_table<2>());

}  // namespace sightline
