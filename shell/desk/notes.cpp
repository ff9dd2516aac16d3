// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/notes.h"

#include "shell/desk/moved.h"
#include "shell/desk/undo.h"

namespace sightline {

template <int D>
void delete_note(Workbench<D>& bench, std::uint32_t index) {
    remember(bench);
    bench.session.notes.erase(bench.session.notes.begin() + index);
    bench.selected_note = none;
    take_along(bench);
}

template void delete_note<2>(Workbench<2>&, std::uint32_t);
template void delete_note<3>(Workbench<3>&, std::uint32_t);

}  // namespace sightline
