// The words of enums, for files, help and menus.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace sightline {

/// The words of an enum in the order of its values; each enum that a person can choose from specialises it.
template <typename E>
inline constexpr std::array<std::string_view, 0> words{};

template <typename E>
constexpr std::string_view word(E value) {
    return words<E>[static_cast<std::size_t>(value)];
}

namespace detail {

template <typename E>
constexpr std::size_t words_size() {
    std::size_t size = 0;
    for (const std::string_view word : words<E>) size += word.size() + 3;
    return size;
}

template <typename E>
struct WordList {
    char text[words_size<E>() + 1] = {};
    std::size_t size = 0;
    constexpr WordList() {
        for (const std::string_view word : words<E>) {
            if (size > 0)
                for (const char c : {' ', '|', ' '}) text[size++] = c;
            for (const char c : word) text[size++] = c;
        }
    }
};
template <typename E>
constexpr WordList<E> word_list_of;

}  // namespace detail

/// "eye | camera", made at compile time.
template <typename E>
constexpr std::string_view word_list() {
    return {detail::word_list_of<E>.text, detail::word_list_of<E>.size};
}

enum class Switch : std::uint8_t { off, on };
template <>
inline constexpr auto words<Switch> = std::to_array<std::string_view>({"off", "on"});

}  // namespace sightline
