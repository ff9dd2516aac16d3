// What the C++ library of Emscripten 3.1.6 (libc++ 13) lacks of C++20: bit_cast, and numbers with a point as text.
// Included before everything else; same results as libstdc++, slower.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#ifdef __cplusplus
#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <type_traits>

namespace std {

#if !defined(__cpp_lib_bit_cast)
template <typename To, typename From>
constexpr To bit_cast(const From& from) noexcept {
    static_assert(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>);
    return __builtin_bit_cast(To, from);
}
#endif

#if !defined(__cpp_lib_to_chars)

namespace sightline_missing {

inline to_chars_result put(char* first, char* last, const char* text, int size) {
    if (size < 0 || size > last - first) return {last, errc::value_too_large};
    memcpy(first, text, static_cast<size_t>(size));
    return {first + size, errc()};
}

}  // namespace sightline_missing

inline to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision) {
    char text[512];
    return sightline_missing::put(
        first, last, text,
        snprintf(text, sizeof text, format == chars_format::fixed ? "%.*f" : "%.*e", precision, value));
}

/// The fewest digits that read back to the same number; with or without an exponent, whichever is shorter.
inline to_chars_result to_chars(char* first, char* last, double value) {
    char text[512];
    if (!isfinite(value)) return sightline_missing::put(first, last, text, snprintf(text, sizeof text, "%g", value));
    int digits = 1;
    for (; digits <= 17; ++digits) {
        snprintf(text, sizeof text, "%.*e", digits - 1, value);
        if (strtod(text, nullptr) == value) break;
    }
    const string with_exponent(text);
    const int exponent = atoi(text + with_exponent.find('e') + 1);
    const int decimals = digits - 1 - exponent > 0 ? digits - 1 - exponent : 0;
    if (decimals < 400) {
        const int size = snprintf(text, sizeof text, "%.*f", decimals, value);
        if (static_cast<size_t>(size) <= with_exponent.size()) return sightline_missing::put(first, last, text, size);
    }
    return sightline_missing::put(first, last, with_exponent.data(), static_cast<int>(with_exponent.size()));
}

/// [-] digits [. digits] [e [+-] digits], infinity or nan: what strtod takes, less white space, plus signs and base 16.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
    const char* at = first;
    const auto digits = [&] {
        const char* const from = at;
        while (at != last && *at >= '0' && *at <= '9') ++at;
        return at - from;
    };
    if (at != last && *at == '-') ++at;
    if (at != last && (*at == 'i' || *at == 'I' || *at == 'n' || *at == 'N')) {
        const string rest(first, last);
        char* end = nullptr;
        const double number = strtod(rest.c_str(), &end);
        if (end == rest.c_str()) return {first, errc::invalid_argument};
        value = number;
        return {first + (end - rest.c_str()), errc()};
    }
    auto count = digits();
    if (at != last && *at == '.') {
        ++at;
        const auto behind = digits();
        if (count + behind == 0) return {first, errc::invalid_argument};
        count += behind;
    }
    if (count == 0) return {first, errc::invalid_argument};
    if (at != last && (*at == 'e' || *at == 'E')) {
        const char* const before = at++;
        if (at != last && (*at == '+' || *at == '-')) ++at;
        if (digits() == 0) at = before;
    }
    const string text(first, at);
    errno = 0;
    const double number = strtod(text.c_str(), nullptr);
    if (errno == ERANGE && (!isfinite(number) || number == 0)) return {at, errc::result_out_of_range};
    value = number;
    return {at, errc()};
}
#endif

}  // namespace std
#endif
