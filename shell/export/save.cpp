// What leaves the bench as text: these need no figure.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/session/state_file.h"
#include "core/space/cells_file.h"
#include "shell/export/export.h"

namespace sightline {

template <int D>
std::string bench_state(const Workbench<D>& bench) {
    if (!bench.other) return state_json<D>(bench.session, bench.figure);
    return state_json<D>(bench.session, bench.figure, &bench.other->session, bench.other->align);
}

template <int D>
void write_cells(Workbench<D>& bench, const std::string& file) {
    const Session<D>& session = bench.session;
    write_cells(session.cells(), session.scene(), session.settings(), file);
    bench.say("wrote " + file + ", " + counted(session.cells().cell_count(), "cell"));
}

void write_text(const std::string& file, const std::string& text) {
    if (file == "-") {
        std::cout << text;
    } else {
        write_file(file, text);
    }
}

#define SIGHTLINE_INSTANTIATE(D)                                     \
    template void write_cells<D>(Workbench<D>&, const std::string&); \
    template std::string bench_state<D>(const Workbench<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
