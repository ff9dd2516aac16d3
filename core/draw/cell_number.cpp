// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/cell_number.h"

#include <algorithm>

namespace sightline {

template <int D>
std::vector<std::optional<double>> cell_numbers(const Session<D>& session, const CellNumber& what) {
    const CellComplex<D>& cells = session.cells();
    std::vector<std::optional<double>> numbers(cells.cell_count());
    if (what.kind == CellNumber::field) {
        for (const Field<D>& field : session.traversal().fields())
            if (field.name == what.name)
                for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
                    numbers[cell] = field.value(session.traversal(), cell_item(cell));
        return numbers;
    }
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        const Mark mark = session.mark(cell);
        switch (what.kind) {
            case CellNumber::solidity:
                if (mark.state == CellState::enqueued || mark.state == CellState::projected) numbers[cell] = mark.key;
                break;
            case CellNumber::count:
                numbers[cell] = cells.count(cell);
                break;
            case CellNumber::share:
                numbers[cell] = session.reference().cell_share[cell];
                break;
            case CellNumber::id:
                numbers[cell] = cell;
                break;
            case CellNumber::zeta:
                for (const std::uint32_t primitive : cells.primitives_of(cell))
                    if (const std::uint32_t zeta = session.layering()[primitive]; zeta > 0)
                        numbers[cell] = std::min<double>(numbers[cell].value_or(zeta), zeta);
                break;
            case CellNumber::order:
            case CellNumber::none:
            case CellNumber::field:
                break;
        }
    }
    if (what.kind == CellNumber::order)
        for (std::uint32_t step = 1; step <= std::min(session.position(), session.recorded()); ++step)
            if (const std::uint32_t cell = id_of(session.timeline().steps[step - 1].item, Kind::cell); cell != none)
                numbers[cell] = step;
    return numbers;
}

template <int D>
std::optional<std::array<double, 2>> number_range(const Session<D>& session, const CellNumber& what) {
    std::optional<std::array<double, 2>> range;
    const auto add = [&range](double number) {
        if (!range) range = {number, number};
        range = {std::min((*range)[0], number), std::max((*range)[1], number)};
    };
    if (what.kind == CellNumber::order) {
        for (std::uint32_t step = 1; step <= session.recorded(); ++step)
            if (session.timeline().steps[step - 1].item.kind == Kind::cell) add(step);
        return range;
    }
    for (const auto& number : cell_numbers(session, what))
        if (number) add(*number);
    if (what.kind == CellNumber::field && session.position() < session.recorded())
        for (const auto& number : cell_numbers(copy_at(session, session.recorded()), what))
            if (number) add(*number);
    if (what.kind == CellNumber::solidity)  // a record holds the key that its step took away, or will give
        for (const Change& change : session.timeline().changes)
            if (change.kind == Kind::cell &&
                (change.state == CellState::enqueued || change.state == CellState::projected))
                add(change.key);
    return range;
}

std::string_view number_title(const CellNumber& what, std::string_view key_title) {
    switch (what.kind) {
        case CellNumber::solidity:
            return key_title;
        case CellNumber::count:
            return "primitives in the cell |A|";
        case CellNumber::order:
            return "step of projection";
        case CellNumber::zeta:
            return "layering number ζ";
        case CellNumber::share:
            return "visible share";
        case CellNumber::id:
            return "cell";
        case CellNumber::field:
            return what.name;
        case CellNumber::none:
            break;
    }
    return "";
}

template std::vector<std::optional<double>> cell_numbers<2>(const Session<2>&, const CellNumber&);
template std::vector<std::optional<double>> cell_numbers<3>(const Session<3>&, const CellNumber&);
template std::optional<std::array<double, 2>> number_range<2>(const Session<2>&, const CellNumber&);
template std::optional<std::array<double, 2>> number_range<3>(const Session<3>&, const CellNumber&);

}  // namespace sightline
