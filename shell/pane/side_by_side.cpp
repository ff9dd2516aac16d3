// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/side_by_side.h"

#include "core/base/number.h"
#include "core/draw/palette.h"
#include "core/session/explain.h"

namespace sightline {

template <int D>
void SideBySide<D>::update(std::uint64_t revision) {
    if (revision_ == revision) return;
    revision_ = revision;
    differences_ = {};
    same_cells_ = true;
    if (!bench_.other) return;
    const Session<D>&left = bench_.session, &right = bench_.other->session;
    same_cells_ = sightline::same_cells(left, right);
    if (same_cells_) differences_ = {cell_differences(left, right), cell_differences(right, left)};
}

template <int D>
const std::optional<std::array<double, 2>>& SideBySide<D>::heat_range(std::size_t pane) {
    const Session<D>& session = (*this)[pane];
    const CellNumber what = session.settings().heat;
    HeatRange& heat = heat_[pane];
    if (heat.run != bench_.run || heat.what != what || heat.of != &session)
        heat = {bench_.run, what, &session,
                what == CellNumber::none || session.flying() ? std::nullopt : number_range(session, what)};
    return heat.range;
}

template <int D>
std::optional<std::uint32_t> SideBySide<D>::facet() const {
    if (!bench_.substep) return std::nullopt;
    return shown_in_substep(bench_.session, bench_.session.position(), *bench_.substep);
}

template <int D>
std::optional<ColourBar> colour_bar(const Session<D>& session, const std::optional<std::array<double, 2>>& range) {
    const Settings& settings = session.settings();
    if (settings.heat == CellNumber::none || !range) return std::nullopt;
    return ColourBar{std::string(number_title(settings.heat, key_title(session))), short_number((*range)[0]),
                     short_number((*range)[1]), colours(settings.palette).heat};
}

template std::optional<ColourBar> colour_bar<2>(const Session<2>&, const std::optional<std::array<double, 2>>&);
template std::optional<ColourBar> colour_bar<3>(const Session<3>&, const std::optional<std::array<double, 2>>&);
template class SideBySide<2>;
template class SideBySide<3>;

}  // namespace sightline
