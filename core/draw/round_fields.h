// What the rounds of a method did to a cell, as the fields of its run tell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/run.h"

namespace sightline {

enum class InRounds : std::uint8_t { nothing, projected, hidden };

template <int D>
class RoundFields {
public:
    explicit RoundFields(const Run<D>& run) : run_(run) {
        for (const Field<D>& field : run.fields()) {
            if (field.name == "round") round_ = &field;
            if (field.name == "hidden") hidden_ = &field;
        }
    }
    InRounds operator()(std::uint32_t cell) const {
        if (is_set(round_, cell)) return InRounds::projected;
        return is_set(hidden_, cell) ? InRounds::hidden : InRounds::nothing;
    }

private:
    bool is_set(const Field<D>* field, std::uint32_t cell) const {
        return field && field->value(run_, cell_item(cell)).value_or(0) > 0;
    }
    const Run<D>& run_;
    const Field<D>*round_ = nullptr, *hidden_ = nullptr;
};

}  // namespace sightline
