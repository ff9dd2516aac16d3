// Settings as a file that viewers and lab take: what one program found out, another one uses.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sightline {

/// {"format": "sightline-settings", "version": 1, "why": "…", "settings": {"error_bound": "0.1", …}}. `assignments` are
/// FIELD=VALUE, `why` a sentence for people.
std::string write_settings(const std::vector<std::string>& assignments, const std::string& why);

/// The assignments, in the file's order, each known and within its range. Throws InputError "name: place: reason".
std::vector<std::string> read_settings(std::string_view text, const std::string& name);

}  // namespace sightline
