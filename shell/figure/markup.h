// What SVG and HTML ask of text and of bytes inside them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sightline {

/// For text between tags and in attributes between double quotes.
std::string escaped(std::string_view text);

/// For data: addresses.
std::string base64(std::string_view data);

}  // namespace sightline
