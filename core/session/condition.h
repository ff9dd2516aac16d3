// Conditions that end a run: step:N, cell:ID, or an expression over the fields of a step's record.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/formula.h"
#include "core/session/session.h"

namespace sightline {

/// A name usable in expressions; its value after the session's last step (NaN where it has none).
template <int D>
struct RecordField {
    std::string_view name;
    std::string_view help;
    double (*value)(const Session<D>&);
};

template <int D>
std::span<const RecordField<D>> record_fields();

/// Operators are those of Formula.
template <int D>
class Condition {
public:
    /// Throws InputError that says what is wrong and where in the text.
    explicit Condition(std::string_view text);

    /// Whether it holds for the session's last step. False at step 0. NaN compares false.
    bool holds(const Session<D>& session) const;
    const std::string& text() const { return text_; }

private:
    std::string text_;
    Formula formula_;
};

extern template class Condition<2>;
extern template class Condition<3>;

/// As Session::run_until.
template <int D>
Stop run_until(Session<D>& session, const Condition<D>& condition);

/// Every recorded step, rising, after which the condition holds, wherever the session stands.
template <int D>
std::vector<std::uint32_t> matches(const Session<D>& session, const Condition<D>& condition);

}  // namespace sightline
