// Owners for the handles of C libraries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace sightline {

template <auto destroy>
struct DestroyWith {
    template <typename T>
    void operator()(T* handle) const {
        destroy(handle);
    }
};

/// Calls `destroy` at the end of its life.
template <typename T, auto destroy>
using Handle = std::unique_ptr<T, DestroyWith<destroy>>;

}  // namespace sightline
