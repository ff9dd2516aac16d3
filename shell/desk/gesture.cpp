// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/gesture.h"

#include "shell/desk/moved.h"
#include "shell/desk/undo.h"

namespace sightline {

template <int D>
Gesture<D> begin_gesture(Workbench<D>& bench) {
    end_gesture(bench);
    return {bench.session, bench.history, bench.marked, bench.marked_by};
}

template <int D>
void cancel_gesture(Workbench<D>& bench, Gesture<D> gesture) {
    bench.session = std::move(gesture.session);
    traversal_changed(bench);
    bench.history = std::move(gesture.history);
    bench.marked = std::move(gesture.marked);
    bench.marked_by = std::move(gesture.marked_by);
}

template Gesture<2> begin_gesture<2>(Workbench<2>&);
template Gesture<3> begin_gesture<3>(Workbench<3>&);
template void cancel_gesture<2>(Workbench<2>&, Gesture<2>);
template void cancel_gesture<3>(Workbench<3>&, Gesture<3>);

}  // namespace sightline
