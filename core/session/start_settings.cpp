// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/start_settings.h"

#include "core/scene/make/catalogue.h"
#include "core/session/settings_table.h"

namespace sightline {

template <int D>
Settings catalogue_settings(const std::string& name) {
    Settings settings;
    const CatalogueRow<D>* row = find_in_catalogue<D>(name);
    if (!row) return settings;
    settings.error_bound = row->error_bound;
    settings.method = row->method;
    settings.budget = parse_budget(row->budget);
    for (const SettingOverride& s : row->settings) apply_setting(settings, std::string(s.field) + "=" + s.value);
    return settings;
}

LoadOptions read_options(const Settings& settings, const Progress& progress) {
    return {.two_sided = settings.two_sided == Switch::on,
            .progress = progress,
            .up = settings.up,
            .degrees = settings.degrees};
}

template Settings catalogue_settings<2>(const std::string&);
template Settings catalogue_settings<3>(const std::string&);

}  // namespace sightline
