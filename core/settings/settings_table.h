// The table of settings: name, default, help, source, what a change invalidates; reading and writing them as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/settings/settings.h"

namespace sightline {

/// What has to be made again when a setting changes; each includes those before it.
enum class Invalidates : std::uint8_t { picture, reference, traversal, tessellation, scene };

struct SettingRow {
    std::string_view name;
    std::string_view help;    ///< one line
    std::string_view source;  ///< where the question comes from, e.g. "TVCG fig. 5, line 1"
    Invalidates invalidates;
    std::string_view values;  ///< the words or the range
    std::string (*get)(const Settings&);
    /// Throws InputError naming the field, the value and what is allowed; then the settings are unchanged.
    std::function<void(Settings&, std::string_view value)> set;
    std::span<const std::string_view> words = {};  ///< of a choice; empty for numbers and free text
    int dimension = 0;                             ///< 2 or 3: only there; 0: in both
};

/// The size that "auto" stands for, or the asked one: D = 2 width x 1, D = 3 width x height.
template <int D>
ImageSize image_size(const ImageSize& asked);

/// The same in words: "8192" or "1024x768".
std::string image_size_text(const ImageSize& size);

std::span<const SettingRow> settings_table();

/// The row of that name; throws InputError that lists the names when there is none.
const SettingRow& setting_row(std::string_view name);

/// Applies "FIELD=VALUE" and returns the row; throws InputError.
const SettingRow& apply_setting(Settings& settings, std::string_view assignment);

struct Preset {
    std::string_view id;
    std::string_view title;
    std::vector<std::string_view> assignments;
};

/// Named sets of assignments, applied on top of the current settings.
std::span<const Preset> presets();

/// Throws InputError that lists the presets when the id is unknown.
void apply_preset(Settings& settings, std::string_view id);

/// The strongest invalidation between two settings; picture when they are equal.
Invalidates difference(const Settings& a, const Settings& b);

}  // namespace sightline
