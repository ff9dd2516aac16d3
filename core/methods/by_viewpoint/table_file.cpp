// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/by_viewpoint/table_file.h"

#include <array>
#include <cstdio>
#include <optional>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/base/json_input.h"
#include "core/base/number.h"
#include "core/base/text.h"

namespace sightline {

namespace {

constexpr const char* file_format = "sightline-viewpoints";
constexpr int file_version = 1;

/// All that the entries depend on, in the order in which it is said to differ.
template <int D>
Json conditions_of(const ViewpointProblem<D>& p) {
    Json asked = Json::object();
    for (const ParameterRow* row : viewpoint_parameter_rows())
        if (row != &table_file_row()) asked[std::string(row->name)] = std::string(p.parameters.text(*row));
    for (const auto& [name, value] : p.parameters.values())
        if (name != table_file_row().name) asked[name] = value;
    const ImageSize image = image_size<D>(p.image);
    return {{"dimension", D},
            {"scene", hash_text(scene_hash(*p.scene))},
            {"image", {image.width, image.height}},
            {"fov", p.fov},
            {"parameters", asked}};
}

/// The shortest decimal that reads back to the same float: a file of many is a third as long.
double shortest(float value) {
    for (int digits = 1; digits < 9; ++digits) {
        std::array<char, 32> text;
        std::snprintf(text.data(), text.size(), "%.*g", digits, static_cast<double>(value));
        const std::optional<double> read = parse_number(text.data());
        if (read && static_cast<float>(*read) == value) return *read;
    }
    return value;
}

/// [place, chosen, reason, interior, few, all, occluders, [primitives], [culling, drawing, drawn, …]]
Json entry_json(std::size_t place, const Entry& entry) {
    const EntryFacts& facts = entry.facts;
    Json costs = Json::array();
    for (const OptionCost& cost : facts.costs) {
        for (const float value : {cost.cull_ms, cost.draw_ms, cost.drawn}) costs.push_back(shortest(value));
    }
    return {place,           entry.chosen,     static_cast<int>(entry.reason),
            facts.interior,  facts.few_cover,  facts.all_cover,
            facts.occluders, facts.candidates, costs};
}

/// Throws Json::exception or std::out_of_range for what cannot be.
template <int D>
void put_entry(const ViewpointTable<D>& table, const Json& row) {
    const auto index_below = [](const Json& value, std::size_t end) {
        const auto index = value.get<std::uint64_t>();
        if (!value.is_number_unsigned() || index >= end) throw std::out_of_range("index");
        return static_cast<std::uint32_t>(index);
    };
    const std::size_t options = table.problem().options.size();
    const std::size_t place = index_below(row.at(0), table.size());
    Entry entry;
    entry.chosen = index_below(row.at(1), options);
    entry.reason = static_cast<ChoiceReason>(index_below(row.at(2), choice_reason_words.size()));
    entry.facts.interior = row.at(3).get<bool>();
    entry.facts.few_cover = row.at(4).get<float>();
    entry.facts.all_cover = row.at(5).get<float>();
    entry.facts.occluders = index_below(row.at(6), none);
    for (const Json& primitive : row.at(7))
        entry.facts.candidates.push_back(index_below(primitive, table.problem().scene->primitives.size()));
    const Json& costs = row.at(8);
    for (std::size_t i = 0; i < options; ++i)
        entry.facts.costs.push_back(
            {costs.at(3 * i).get<float>(), costs.at(3 * i + 1).get<float>(), costs.at(3 * i + 2).get<float>()});
    table.put(place, std::move(entry));
}

}  // namespace

template <int D>
void write_table(const ViewpointTable<D>& table, const std::filesystem::path& path) {
    Json root = conditions_of(table.problem());
    root["format"] = file_format;
    root["version"] = file_version;
    root["regions"] = table.regions().count();
    root["intervals"] = table.directions().count();
    root["entries"] = Json::array();
    for (std::size_t place = 0; place < table.size(); ++place)
        if (const Entry* entry = table.find(place)) root["entries"].push_back(entry_json(place, *entry));
    write_file(path, root.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

template <int D>
void read_table(const ViewpointTable<D>& table, const std::filesystem::path& path) {
    const std::string name = path.string();
    const Json root = parse_json(read_file(path, largest_json), name);
    if (!root.is_object() || root.value("format", Json()) != file_format)
        throw input_error(name, "", "is no table by viewpoint: format is not " + std::string(file_format));
    if (root.value("version", Json()) != file_version)
        throw input_error(name, "", "is of another version: expected " + std::to_string(file_version));
    const Json asked = conditions_of(table.problem());
    for (const char* what : {"dimension", "scene"})
        if (root.value(what, Json()) != asked[what])
            throw input_error(name, what, "was worked out for another " + std::string(what));
    for (const char* what : {"image", "fov"})
        if (root.value(what, Json()) != asked[what])
            throw input_error(
                name, what,
                "was worked out for " + root.value(what, Json()).dump() + ", and is asked for " + asked[what].dump());
    const Json stored = root.value("parameters", Json::object());
    for (const auto& [parameter, value] : asked["parameters"].items())
        if (!stored.is_object() || stored.value(parameter, Json()) != value)
            throw input_error(
                name, "parameters/" + parameter,
                "was worked out with " + stored.value(parameter, Json()).dump() + ", and is asked for " + value.dump());
    if (stored != asked["parameters"]) throw input_error(name, "parameters", "were others");
    try {
        for (const Json& row : root.at("entries")) put_entry(table, row);
    } catch (const Json::exception&) {
        throw input_error(name, "entries", "is damaged");
    } catch (const std::out_of_range&) {
        throw input_error(name, "entries", "is damaged: an index is out of range");
    }
}

#define SIGHTLINE_INSTANTIATE(D)                                                          \
    template void write_table<D>(const ViewpointTable<D>&, const std::filesystem::path&); \
    template void read_table<D>(const ViewpointTable<D>&, const std::filesystem::path&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
