// A value that is made when it is first asked for.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

namespace sightline {

/// Any thread may ask; one makes, the others wait.
template <typename T>
class Lazy {
public:
    template <typename Make>
    const T& of(Make make) const {
        std::call_once(once_, [&] { value_ = make(); });
        return value_;
    }

private:
    mutable std::once_flag once_;
    mutable T value_;
};

}  // namespace sightline
