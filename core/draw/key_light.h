// What a term of a key speaks of in the picture, as lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/session/session.h"

namespace sightline {

/// A term of the key that a cell was given across a facet.
struct KeyLight {
    KeyAbout about = KeyAbout::nothing;
    std::uint32_t from = none, facet = none, cell = none;  ///< ids; `from` handed the key to `cell`

    explicit operator bool() const { return about != KeyAbout::nothing; }
    bool operator==(const KeyLight&) const = default;
};

/// Of the key that `update` computed.
KeyLight light_of(const Considered& update, KeyAbout about);

template <int D>
struct LightLine {
    std::vector<Vec<D>> points;  ///< scene units, two or more
    bool closed = false;
    bool arrow = false;  ///< its last point carries a head
};

/// content, handed_on: the cell before; own: the cell; angle: the facet, the eye's ray to it and its normal; star: the
/// facet and the ray to the cell's centre. Empty for nothing, and for ids that the session does not have.
template <int D>
std::vector<LightLine<D>> key_light(const Session<D>& session, const KeyLight& light);

}  // namespace sightline
