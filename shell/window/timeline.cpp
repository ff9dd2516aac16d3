// The lanes of the recorded run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/parts.h"

namespace sightline {

template <int D>
void timeline(Ui&, Workbench<D>&, const Area& area) {
    begin_part("timeline", area);
    ImGui::End();
}

template void timeline<2>(Ui&, Workbench<2>&, const Area&);

}  // namespace sightline
