// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/excerpt.h"

#include "core/base/text.h"

namespace sightline {

std::string excerpt(std::string_view text) { return one_line(text, 60); }

std::string error_line(std::string_view text) {
    constexpr std::size_t most = 400, first = 100;
    if (text.size() <= most) return one_line(text, most);
    std::string_view rest = text.substr(text.size() - (most - first));
    while (!rest.empty() && (static_cast<unsigned char>(rest.front()) & 0xc0) == 0x80) rest.remove_prefix(1);
    return one_line(text, first) + one_line(rest, most);
}

}  // namespace sightline
