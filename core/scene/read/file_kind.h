// What a file holds, told by its name and its first bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sightline {

/// ".obj": the ending of the path, in small letters; empty where it has none.
std::string ending_of(const std::string& path);

/// "a PNG picture", where the file begins like a format that its ending does not stand for; nothing where it does not,
/// where it begins like none that is known, and where it cannot be read.
std::string kind_behind(const std::string& path);

/// "a gzip archive": what the first bytes of a file begin like; nothing where that is not known.
std::string kind_of(std::string_view bytes);

/// The reason why a file cannot be read, and what it holds, where that is another format than its ending says: people
/// look for the mistake there.
std::string with_kind(const std::string& reason, const std::string& path);

}  // namespace sightline
