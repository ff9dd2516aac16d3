// Conditions that end a run: step:N, cell:ID, primitive:ID, object:NAME, or an expression over the fields of a record.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
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

/// The fields of a method (Run::fields) whose names record_fields() does not have.
template <int D>
std::vector<Field<D>> own_fields(std::span<const Field<D>> of_method);

/// Operators are those of Formula.
template <int D>
class Condition {
public:
    /// Beside the names of record_fields() those of the method's own fields (Run::fields) are known, of what the step
    /// popped. primitive:ID and object:NAME hold for a step that renders it, or something of the object. Throws
    /// InputError that says what is wrong and where in the text.
    explicit Condition(std::string_view text, std::span<const Field<D>> of_method = {});

    /// Whether it holds for the session's last step. False at step 0. NaN compares false; a field that the run does not
    /// have is NaN.
    bool holds(const Session<D>& session) const;
    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::vector<std::string_view> own_;  ///< names of own_fields(), behind those of record_fields()
    std::optional<Formula> formula_;     ///< nothing: whether the step renders something of these
    std::string object_;                 ///< its name; empty: the primitive
    std::uint32_t primitive_ = none;
};

extern template class Condition<2>;
extern template class Condition<3>;

/// One over what the session's method has.
template <int D>
Condition<D> condition_for(const Session<D>& session, std::string_view text) {
    return Condition<D>(text, session.traversal().fields());
}

/// Nothing where it names what the session's method does not have: such a condition never holds here.
template <int D>
std::optional<Condition<D>> condition_here(const Session<D>& session, std::string_view text);

/// As Session::run_until.
template <int D>
Stop run_until(Session<D>& session, const Condition<D>& condition);

/// Every recorded step, rising, after which the condition holds, wherever the session stands.
template <int D>
std::vector<std::uint32_t> matches(const Session<D>& session, const Condition<D>& condition);

}  // namespace sightline
