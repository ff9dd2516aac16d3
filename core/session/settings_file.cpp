// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/settings_file.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/session/settings_table.h"

namespace sightline {

using OrderedJson = nlohmann::ordered_json;

std::string write_settings(const std::vector<std::string>& assignments, const std::string& why) {
    OrderedJson json{
        {"format", "sightline-settings"}, {"version", 1}, {"why", why}, {"settings", OrderedJson::object()}};
    for (const std::string& assignment : assignments) {
        const std::size_t equals = assignment.find('=');
        json["settings"][assignment.substr(0, equals)] = assignment.substr(equals + 1);
    }
    return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

std::vector<std::string> read_settings(std::string_view text, const std::string& name) {
    const OrderedJson json = OrderedJson::parse(text, nullptr, false);
    if (json.is_discarded()) throw InputError(name + ": not JSON");
    if (!json.is_object() || json.value("format", OrderedJson()) != "sightline-settings")
        throw InputError(name + ": format: not sightline-settings");
    if (json.value("version", OrderedJson()) != 1) throw InputError(name + ": version: only 1 can be read");
    if (!json.contains("settings") || !json["settings"].is_object())
        throw InputError(name + ": settings: expected an object");
    std::vector<std::string> assignments;
    Settings settings;
    for (const auto& [field, value] : json["settings"].items()) {
        if (!value.is_string() && !value.is_number())
            throw InputError(name + ": settings: " + field + ": expected text or a number");
        assignments.push_back(field + "=" + (value.is_string() ? value.get<std::string>() : value.dump()));
        try {
            apply_setting(settings, assignments.back());
        } catch (const InputError& error) {
            throw InputError(name + ": settings: " + error.what());
        }
    }
    return assignments;
}

}  // namespace sightline
