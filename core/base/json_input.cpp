// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_input.h"

#include <cmath>

#include "core/base/text.h"

namespace sightline {

namespace {

void check_depth(std::string_view text, const std::string& name) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
        } else if (c == '"') {
            in_string = true;
        } else if (c == '[' || c == '{') {
            if (++depth > deepest_json)
                throw input_error(name, line_and_column(text, i),
                                  "nested deeper than " + std::to_string(deepest_json) + " levels");
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
}

/// The library's reason without its own prefix and position, which counts differently.
std::string reason_of(const Json::exception& error) {
    std::string reason = error.what();
    const std::size_t prefix = reason.find("] ");
    if (prefix != std::string::npos) reason.erase(0, prefix + 2);
    const std::size_t column = reason.find(", column ");
    const std::size_t colon = reason.find(": ", column == std::string::npos ? 0 : column);
    if (column != std::string::npos && colon != std::string::npos) reason.erase(0, colon + 2);
    return one_line(reason);
}

}  // namespace

Json parse_json(std::string_view text, const std::string& name) {
    if (text.size() > largest_json)
        throw input_error(name, "",
                          std::to_string(text.size()) + " bytes of JSON; the limit is " + std::to_string(largest_json));
    check_depth(text, name);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw input_error(name, line_and_column(text, error.byte > 0 ? error.byte - 1 : 0), reason_of(error));
    } catch (const Json::exception& error) {
        // A number beyond the range of doubles: the library quotes it but does not say where it stands.
        const std::string reason = reason_of(error);
        const std::size_t from = reason.find('\'') + 1, to = reason.rfind('\'');
        const std::size_t at = from > 0 && to > from ? text.find(reason.substr(from, to - from)) : std::string::npos;
        throw input_error(name, at == std::string::npos ? "" : line_and_column(text, at), reason);
    }
}

std::string JsonPlace::text() const {
    if (!parent) return "";
    return parent->text() + "/" + (key ? std::string(key) : std::to_string(index));
}

const char* json_kind(const Json& value) {
    switch (value.type()) {
        case Json::value_t::object:
            return "an object";
        case Json::value_t::array:
            return "an array";
        case Json::value_t::string:
            return "a string";
        case Json::value_t::boolean:
            return "true or false";
        case Json::value_t::null:
            return "null";
        default:
            return "a number";
    }
}

double json_number(const Json& value, const JsonPlace& place, const std::string& name) {
    if (!value.is_number())
        throw input_error(name, place.text(), std::string("expected a number, found ") + json_kind(value));
    const double number = value.get<double>();
    if (!std::isfinite(number)) throw input_error(name, place.text(), "the number is beyond the range of doubles");
    return number;
}

}  // namespace sightline
