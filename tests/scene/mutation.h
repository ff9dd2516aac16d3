// Seeded mutations of valid inputs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/random.h"
#include "tests/scene/scene_support.h"
#include "tests/soak.h"

namespace sightline::test {

/// How many a test tries.
inline std::size_t input_count() { return static_cast<std::size_t>(soak_count(2000)); }

inline constexpr const char* tokens[] = {
    "1e999", "-1e308", "1e151", "NaN", "-Infinity", "0x10", "1e-320", "-0.0",
    "null",  "true",   "\"a\"", "[]",  "{}",        "[[",   "]]",     "99999999999999999999",
    "1e",    "-",      "1.5.2", "\\u", "\xff",      "2",    "360",    "{\"type\":0}",
    "[[[[[1"};
inline constexpr std::uint32_t patterns[] = {0,      1,      0x7f,       0x80,       0xff,      0x7fff,
                                             0x8000, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff};

inline std::size_t place(Random& random, const std::string& bytes) { return random.below(bytes.size() + 1); }

/// Replaces a run that looks like a number (any length, may be empty) by a token.
inline void replace_number(Random& random, std::string& bytes) {
    std::size_t from = bytes.find_first_of("-0123456789", place(random, bytes));
    if (from == std::string::npos) return;
    std::size_t to = bytes.find_first_not_of("+-.0123456789eE", from);
    if (to == std::string::npos) to = bytes.size();
    bytes.replace(from, to - from, tokens[random.below(std::size(tokens))]);
}

inline void mutate(Random& random, std::string& bytes, const std::string& other, bool binary) {
    switch (random.below(14)) {  // mostly single values, so that many inputs get past the parser
        case 0:                  // flip a bit
            if (!bytes.empty()) bytes[random.below(bytes.size())] ^= static_cast<char>(1 << random.below(8));
            break;
        case 1:
            bytes.resize(place(random, bytes));
            break;
        case 2: {  // splice
            const std::size_t from = place(random, other);
            bytes.replace(place(random, bytes), random.below(40), other, from, random.below(60));
            break;
        }
        case 3:
            bytes.erase(place(random, bytes), random.below(16));
            break;
        case 4:  // repeat a piece
            if (bytes.size() < 20000) bytes.insert(place(random, bytes), bytes, place(random, bytes), random.below(80));
            break;
        default:
            if (!binary) {
                replace_number(random, bytes);
            } else {
                const int size = random.below(2) ? 4 : 2;
                const std::size_t at = place(random, bytes);
                if (at + 4 <= bytes.size())
                    bytes.replace(at, static_cast<std::size_t>(size),
                                  little(patterns[random.below(std::size(patterns))], size));
            }
    }
}

}  // namespace sightline::test
