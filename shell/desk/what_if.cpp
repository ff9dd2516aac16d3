// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/what_if.h"

namespace sightline {

namespace {

/// About a fifth of a second.
constexpr std::uint64_t steps_of_a_moment = 400'000;

}  // namespace

template <int D>
Item selected_item(const Workbench<D>& bench) {
    const Session<D>& session = bench.session;
    if (session.selected_primitive != none) return primitive_item(session.selected_primitive);
    return cell_item(session.selected_cell);
}

template <int D>
const Counterfactuals* what_if(const Workbench<D>& bench) {
    const auto& kept = bench.what_if;
    return kept && kept->run == bench.run && kept->all.item == selected_item(bench) ? &kept->all : nullptr;
}

template <int D>
bool update_what_if(Workbench<D>& bench, bool however_long) {
    const Item item = selected_item(bench);
    if (!item || bench.session.flying() || what_if(bench)) return false;
    if (item.kind == Kind::cell && !bench.session.method().orders_cells()) return false;
    if (!however_long && most_steps(bench.session) > steps_of_a_moment) return false;
    bench.what_if = {bench.run, counterfactuals(bench.session, item)};
    return true;
}

#define SIGHTLINE_INSTANTIATE(D)                                     \
    template Item selected_item<D>(const Workbench<D>&);             \
    template const Counterfactuals* what_if<D>(const Workbench<D>&); \
    template bool update_what_if<D>(Workbench<D>&, bool);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
