// JSON for the page, written as it goes: smaller and faster than a tree of values that is then dumped.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace sightline {

class JsonText {
public:
    JsonText& object() { return open('{'); }
    JsonText& array() { return open('['); }
    /// Ends what was begun last.
    JsonText& end_object() { return close('}'); }
    JsonText& end_array() { return close(']'); }

    JsonText& name(std::string_view text);
    JsonText& value(std::string_view text);
    JsonText& value(const char* text) { return value(std::string_view(text)); }
    JsonText& value(double number);  ///< null for one that is not finite
    JsonText& value(float number) { return value(static_cast<double>(number)); }
    JsonText& value(std::same_as<bool> auto truth) { return word(truth ? "true" : "false"); }
    JsonText& value(std::integral auto number) requires(!std::same_as<decltype(number), bool>) {
        return word(std::to_string(number));
    }
    template <typename T>
    JsonText& member(std::string_view named, const T& what) {
        return name(named).value(what);
    }
    template <typename List>
    JsonText& values(const List& list) {
        array();
        for (const auto& one : list) value(one);
        return end_array();
    }
    std::string take() { return std::move(text_); }

private:
    JsonText& open(char bracket);
    JsonText& close(char bracket);
    JsonText& word(std::string_view text);
    void quoted(std::string_view text);

    std::string text_;
    bool more_ = false;  ///< the next value or name stands behind a comma
};

}  // namespace sightline
