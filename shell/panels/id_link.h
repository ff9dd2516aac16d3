// Numbers in a text that name something: "cell 12", "triangles 4 and 5", "step 37". A click on one goes there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sightline {

/// Where in a text a number names something, and the command that goes to it. Empty command: nowhere.
struct IdLink {
    std::size_t first = 0, count = 0;  ///< bytes
    std::string command;
};

/// The one that holds byte `at` of the text.
IdLink id_link_at(std::string_view text, std::size_t at);

}  // namespace sightline
