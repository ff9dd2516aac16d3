// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/json_text.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace sightline {

JsonText& JsonText::open(char bracket) {
    if (more_) text_ += ',';
    text_ += bracket;
    more_ = false;
    return *this;
}

JsonText& JsonText::close(char bracket) {
    text_ += bracket;
    more_ = true;
    return *this;
}

JsonText& JsonText::word(std::string_view text) {
    if (more_) text_ += ',';
    text_ += text;
    more_ = true;
    return *this;
}

void JsonText::quoted(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    if (more_) text_ += ',';
    text_ += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\') text_ += '\\';
        if (static_cast<unsigned char>(c) >= 0x20) {
            text_ += c;
            continue;
        }
        text_ += "\\u00";
        text_ += digits[static_cast<std::size_t>(c >> 4)];
        text_ += digits[static_cast<std::size_t>(c & 15)];
    }
    text_ += '"';
}

JsonText& JsonText::name(std::string_view text) {
    quoted(text);
    text_ += ':';
    more_ = false;
    return *this;
}

JsonText& JsonText::value(std::string_view text) {
    quoted(text);
    more_ = true;
    return *this;
}

JsonText& JsonText::value(double number) {
    return word(std::isfinite(number) ? nlohmann::json(number).dump() : "null");
}

}  // namespace sightline
