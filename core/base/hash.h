// A 64-bit hash of plain values, the same on every x86-64 machine. For identity checks, not for security.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>

namespace sightline {

class Hash {
public:
    void add(std::uint64_t word) {
        state_ = (state_ ^ word) * 0x9fb21c651e98df25ull;
        state_ ^= state_ >> 32;
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    template <typename T>
    requires std::is_integral_v<T> || std::is_enum_v<T>
    void add(T value) { add(static_cast<std::uint64_t>(value)); }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0x2545f4914f6cdd1dull;
};

/// Sixteen lower-case hexadecimal digits.
std::string hash_text(std::uint64_t value);

}  // namespace sightline
