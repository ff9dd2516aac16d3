// Why a box of a tree is drawn, waits or is dropped.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/session/session.h"

namespace sightline {

/// The smallest box around the primitive that the walk has come to; none for a method that walks no boxes.
template <int D>
std::uint32_t box_around(const Session<D>& session, std::uint32_t primitive);

/// "node 41, 24 triangles: it is hidden: 88 pixels of it, behind triangles 7, 9". The node is one of the tree.
template <int D>
std::string box_sentence(const Session<D>& session, std::uint32_t node);

}  // namespace sightline
