// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/choice.h"

#include <algorithm>

#include "core/base/number.h"

namespace sightline {

namespace {

template <int D>
const Step* last_step(const Session<D>& session) {
    const std::uint32_t position = session.position();
    return position == 0 || position > session.recorded() ? nullptr : &session.timeline().steps[position - 1];
}

/// The key that a waiting cell had before the last step, where that step gave it another one.
template <int D>
std::optional<double> earlier_key(const Session<D>& session, std::uint32_t cell) {
    if (session.mark(cell).state != CellState::enqueued) return std::nullopt;
    for (const Change& change : session.timeline().changes_of(session.position()))
        if (change.kind == Kind::cell && change.id == cell && change.state == CellState::enqueued &&
            change.key != session.mark(cell).key)
            return change.key;
    return std::nullopt;
}

}  // namespace

template <int D>
Choice choice_of(const Session<D>& session) {
    const Step* step = last_step(session);
    if (!step || step->item.kind != Kind::cell) return {};
    return {step->item.id, id_of(step->runner_up, Kind::cell)};
}

template <int D>
std::string cell_label(const Session<D>& session, const Choice& choice, std::uint32_t cell, double number) {
    const std::string text = short_number(number);
    if (choice.taken == none || session.settings().label != CellNumber::solidity) return text;
    const std::string name = std::to_string(cell) + " · ";
    if (const auto before = earlier_key(session, cell)) {
        const int digits = separating_digits(*before, number);
        return name + short_number(*before, digits) + " → " + short_number(number, digits);
    }
    return cell == choice.taken || cell == choice.next ? name + text : text;
}

template <int D>
std::uint32_t first_in_front(const Session<D>& session) {
    std::uint32_t first = none;
    for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
        const Mark mark = session.mark(cell);
        if (mark.state == CellState::enqueued && (first == none || comes_before(mark, session.mark(first))))
            first = cell;
    }
    return first;
}

template std::uint32_t first_in_front<2>(const Session<2>&);
template std::uint32_t first_in_front<3>(const Session<3>&);
template Choice choice_of<2>(const Session<2>&);
template Choice choice_of<3>(const Session<3>&);
template std::string cell_label<2>(const Session<2>&, const Choice&, std::uint32_t, double);
template std::string cell_label<3>(const Session<3>&, const Choice&, std::uint32_t, double);

}  // namespace sightline
