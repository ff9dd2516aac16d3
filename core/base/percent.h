// Bytes as text and back, as in addresses: "my%20file".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sightline {

/// Printable ASCII but the percent sign stays, all else becomes %XX.
std::string percent_encoded(std::string_view bytes);

/// The other way; what is no percent sign with two hexadecimal digits stays.
std::string percent_decoded(std::string_view text);

}  // namespace sightline
