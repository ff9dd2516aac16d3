// The table of settings: name, default, help, source, what a change invalidates; reading and writing them as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/method.h"
#include "core/session/settings.h"

namespace sightline {

/// What has to be made again when a setting changes; each includes those before it.
enum class Invalidates : std::uint8_t { picture, reference, traversal, tessellation, scene };

struct SettingRow {
    std::string_view name;
    std::string_view help;    ///< one line
    std::string_view source;  ///< where the question comes from, e.g. "TVCG fig. 5, line 1"
    Invalidates invalidates;
    std::string_view values;  ///< the words or the range
    std::function<std::string(const Settings&)> get;
    /// Throws InputError naming the field, the value and what is allowed; then the settings are unchanged.
    std::function<void(Settings&, std::string_view value)> set;
    std::span<const std::string_view> words = {};  ///< of a choice; empty for numbers and free text
    int dimension = 0;                             ///< 2 or 3: only there; 0: in both
    const ParameterRow* parameter = nullptr;       ///< of a method: the others have no use for it
};

/// The row of a method's parameter.
SettingRow parameter_setting(const ParameterRow& row);

/// The rows of a session, and behind the budget the parameters of all methods in the table.
std::span<const SettingRow> settings_table();

/// Whether a row is one of the dimension, and no parameter that the method does not have.
template <int D>
bool applies(const SettingRow& row, const Method<D>& method) {
    return (row.dimension == 0 || row.dimension == D) && (!row.parameter || method.parameter(row.name));
}

/// The row of that name; throws InputError that lists the names when there is none.
const SettingRow& setting_row(std::string_view name);

/// Applies "FIELD=VALUE" and returns the row; throws InputError.
const SettingRow& apply_setting(Settings& settings, std::string_view assignment);

/// The same where FIELD may also be a parameter of a method that is in no table of ours.
template <int D>
void apply_setting(Settings& settings, std::string_view assignment, const Method<D>& method) {
    const ParameterRow* const row = method.parameter(assignment.substr(0, assignment.find('=')));
    if (row && assignment.find('=') != std::string_view::npos)
        settings.parameters.set(*row, assignment.substr(assignment.find('=') + 1));
    else
        apply_setting(settings, assignment);
}

struct Preset {
    std::string_view id;
    std::string_view title;
    std::vector<std::string_view> assignments;
    std::string_view method{};  ///< that it is a form of, which it puts in place of one that `auto` chose
};

/// Named sets of assignments, applied on top of the current settings. They set parameters of methods and leave the
/// tessellation alone: what they are compared with then has the same cells.
std::span<const Preset> presets();

/// Throws InputError that lists the presets when the id is unknown.
void apply_preset(Settings& settings, std::string_view id);

/// The strongest invalidation between two settings; picture when they are equal.
Invalidates difference(const Settings& a, const Settings& b);

}  // namespace sightline
