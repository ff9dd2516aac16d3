// A formula over named numbers, which may also be true or false.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sightline {

/// Operators are those of muParser: + - * / ^ < <= > >= == != && || ?: and !.
class Formula {
public:
    /// Throws InputError "condition 'TEXT': reason", which lists the names where one is unknown; `shown` stands for
    /// TEXT.
    Formula(const std::string& text, std::vector<std::string> names, const std::string& shown);
    Formula(Formula&&) noexcept;
    Formula& operator=(Formula&&) noexcept;
    ~Formula();

    /// Indices of the names that the text mentions: the other values are not looked at.
    std::span<const std::size_t> used() const;
    /// A value per name. Whether the result is neither 0 nor NaN.
    bool holds(std::span<const double> values) const;

private:
    struct Parsed;
    std::unique_ptr<Parsed> parsed_;
};

}  // namespace sightline
