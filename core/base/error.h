// The one exception type of the border: input that cannot be used.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace sightline {

/// Bad input or wrong usage: what() is one line that says what, where and why. Programs print it and exit with 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Something failed while working (a full disk, say). Programs print it and exit with 1.
struct WorkError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace sightline
