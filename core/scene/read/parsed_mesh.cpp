// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/parsed_mesh.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>

#include "core/base/number.h"

namespace sightline {

std::optional<double> number_in_file(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0;
    const char* const past = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), past, value);
    if (error == std::errc::result_out_of_range && end == past)
        return std::strtod(std::string(word).c_str(), nullptr);  // infinite, or zero
    if (error != std::errc()) return {};
    if (end == past) return value;
    const std::string_view rest(end, static_cast<std::size_t>(past - end));
    if (rest.starts_with("#QNAN") || rest.starts_with("#SNAN") || rest.starts_with("#IND") || rest.starts_with("#INF"))
        return std::numeric_limits<double>::quiet_NaN();  // as Microsoft's library writes it
    return {};
}

std::string in_small_letters(std::string_view word) {
    std::string small(word);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
    return small;
}

InputError error_at(std::string_view text, std::size_t at, const std::string& reason) {
    const std::string_view before = text.substr(0, at);
    auto lines = std::count(before.begin(), before.end(), '\n');
    if (lines == 0) lines = std::count(before.begin(), before.end(), '\r');
    return InputError("line " + std::to_string(lines + 1) + ": " + reason);
}

void check_memory(std::uint64_t triangles, std::uint64_t points) {
    // A triangle with what cleaning takes, and its object.
    const double bytes = 96 * static_cast<double>(triangles) + 24 * static_cast<double>(points);
    const double there = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    if (bytes > there)
        throw InputError("holds " + std::to_string(triangles) + " triangles, which need " + short_number(bytes / 1e9) +
                         " GB of memory; this machine has " + short_number(there / 1e9));
}

}  // namespace sightline
